#pragma once

#include "topology/tables/entity_tables.h"

namespace topology {

/// The tables before and after a step, with the marks of what it made, killed and changed: a killed row in `before`, a
/// created one in `after`, and in both each cell that differs.
struct ComparedTables {
    EntityTables before, after;
};
ComparedTables compared(EntityTables before, EntityTables after);

} // namespace topology
