// Where edges and vertices are, in cells.
#include "topology/planar/planar_subdivision.h"

namespace topology {

/// Cells for all that is there, and for what comes next.
void PlanarSubdivision::fit_grid(const FlatBox& box)
{
    const bool is_crowded = solid_.edges().n_rows() > 4 * n_expected_;
    if (edges_.covers(box) && !is_crowded) return;
    if (is_crowded) n_expected_ = 2 * solid_.edges().n_rows();
    FlatBox all = box;
    if (!edges_.box().is_empty()) {
        all.add(edges_.box().low);
        all.add(edges_.box().high);
    }
    all = all.grown(std::max(0.1 * all.diagonal(), 10.0 * snap_));
    edges_ = EdgeGrid(all, n_expected_);
    points_ = EdgeGrid(all, std::max<std::size_t>(64, n_expected_ / 16));
    for (const EdgeId e : solid_.edges()) add_to_grid(e);
    n_changes_in_grid_ = changes_.size();
    std::erase_if(lone_vertices_, [&](VertexId v) { return !solid_.has(v); });
    for (const VertexId v : lone_vertices_) points_.put_at(at(v), v.index);
}

void PlanarSubdivision::add_to_grid(EdgeId e)
{
    const CurvePart& of = parts_[e.index];
    edges_.put_along(curves_[of.curve], of.span, snap_, e.index);
}

} // namespace topology
