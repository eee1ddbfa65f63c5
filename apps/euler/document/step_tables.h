#pragma once

#include <cstddef>

#include "apps/euler/document/stepper.h"
#include "topology/tables/compared_tables.h"

namespace euler {

/// The tables of the step's solid before and after it, what it changed being marked; no rows where the solid was not
/// yet or is no more.   \pre 1 <= step <= lesson.n_steps()
topology::ComparedTables step_tables(const Stepper& lesson, std::size_t step);

} // namespace euler
