#include "apps/euler/document/step_tables.h"

namespace euler {

namespace {

topology::EntityRows rows(std::span<const Snapshot> solids, std::size_t solid)
{
    if (solid >= solids.size() || !solids[solid].is_alive()) return {};
    return topology::EntityRows(*solids[solid].solid, topology::place_among_living(solids, solid));
}

} // namespace

topology::ComparedTables step_tables(std::span<const Snapshot> before, std::span<const Snapshot> after,
                                     std::size_t solid)
{
    return {rows(before, solid), rows(after, solid)};
}

} // namespace euler
