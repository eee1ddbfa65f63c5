#include "femoop/solver/metis_ordering.h"

#include <metis.h>

namespace femoop {

std::vector<std::int32_t> metis_order(const BlockAdjacency& adjacency)
{
    std::vector<idx_t> start(adjacency.start.begin(), adjacency.start.end()); // METIS takes pointers to what it keeps
    std::vector<idx_t> neighbours(adjacency.neighbours.begin(), adjacency.neighbours.end());
    auto n = static_cast<idx_t>(adjacency.n_blocks());
    std::vector<idx_t> order(adjacency.n_blocks()), place(adjacency.n_blocks());
    if (METIS_NodeND(&n, start.data(), neighbours.data(), nullptr, nullptr, order.data(), place.data()) != METIS_OK)
        return {};
    return {order.begin(), order.end()};
}

} // namespace femoop
