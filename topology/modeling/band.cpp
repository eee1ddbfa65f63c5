#include "topology/modeling/band.h"

namespace topology {

std::vector<HalfEdgeId> add_band(EulerOperator& op, HalfEdgeId from, HalfEdgeId to)
{
    const Solid& solid = op.solid();
    std::vector<HalfEdgeId> near, far; // partners: near[i] and far[i]
    for (HalfEdgeId h = from; near.empty() || h != from; h = solid.next(h)) near.push_back(h);
    for (HalfEdgeId h = to; far.empty() || h != to; h = solid.prev(h)) far.push_back(h);
    std::vector<HalfEdgeId> across{op.mekr(from, to).plus};
    for (std::size_t i = 1; i < near.size(); ++i) across.push_back(op.mef(far[i], near[i]).minus);
    return across;
}

} // namespace topology
