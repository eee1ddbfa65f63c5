#pragma once

#include <cstddef>
#include <span>

#include "apps/euler/document/snapshot.h"
#include "topology/tables/compared_tables.h"

namespace euler {

/// The tables of a solid before and after a step, what it changed being marked; no rows where the solid was not yet or
/// is no more. The solids must outlive the tables.
topology::ComparedTables step_tables(std::span<const Snapshot> before, std::span<const Snapshot> after,
                                     std::size_t solid);

} // namespace euler
