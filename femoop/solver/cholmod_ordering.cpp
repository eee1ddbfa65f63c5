#include "femoop/solver/cholmod_ordering.h"

#include "femoop/solver/cholmod_session.h"

namespace femoop {

std::vector<std::int32_t> nested_dissection(const BlockAdjacency& adjacency)
{
    CholmodSession session;
    std::vector<std::int32_t> start = adjacency.start;
    std::vector<std::int32_t> neighbours = adjacency.neighbours;
    cholmod_sparse graph{};
    graph.nrow = graph.ncol = adjacency.n_blocks();
    graph.nzmax = neighbours.size();
    graph.p = start.data();
    graph.i = neighbours.data();
    graph.stype = -1; // CHOLMOD reads the lower triangle of it
    graph.itype = CHOLMOD_INT;
    graph.xtype = CHOLMOD_PATTERN;
    graph.dtype = CHOLMOD_DOUBLE;
    graph.sorted = 0;
    graph.packed = 1;
    std::vector<std::int32_t> order(adjacency.n_blocks());
    if (!cholmod_metis(&graph, nullptr, 0, 0, order.data(), &session.common)) order.clear();
    return order;
}

} // namespace femoop
