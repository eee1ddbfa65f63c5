#include "apps/plane/document/outlines.h"

#include <algorithm>
#include <vector>

#include "apps/plane/document/curve_draft.h"
#include "apps/plane/document/erase.h"
#include "apps/plane/document/points.h"

namespace plane {

using discretize::Drawing;
using femoop::plane::DrawnPlace;

namespace {

constexpr double widest = 0.05; // of the drawing's box: other curves farther off were not meant
constexpr double narrow = 0.02; // of the drawing: ends that near were meant to meet

/// A vertex, its point and whether only one edge ends there.
struct End {
    topology::VertexId vertex;
    FlatPoint at;
    std::optional<NodeId> point;
    bool is_free = false;
    std::optional<topology::VertexId> neighbour{}; ///< of a free end
    std::size_t component = 0;                     ///< the same for all that hangs together
};

/// Which vertices hang together.
class Components {
public:
    explicit Components(const topology::Solid& solid) : parent_(solid.vertices().n_rows())
    {
        for (std::size_t i = 0; i < parent_.size(); ++i) parent_[i] = i;
        for (const topology::EdgeId e : solid.edges())
            parent_[root(solid.start(solid.plus(e)).index)] = root(solid.end(solid.plus(e)).index);
    }
    std::size_t root(std::size_t i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

private:
    std::vector<std::size_t> parent_;
};

std::vector<End> ends_of(const Drawing& drawing)
{
    std::vector<End> ends;
    const auto& plane = drawing.subdivision();
    const topology::Solid& solid = plane.solid();
    if (solid.is_empty()) return ends;
    Components components(solid);
    for (const topology::VertexId v : solid.vertices()) {
        const topology::HalfEdgeId h = solid.half_edge(v);
        if (!solid.edge(h)) continue;
        std::size_t n = 0;
        topology::HalfEdgeId leaving = h;
        for (const topology::HalfEdgeId each : solid.fan(v)) {
            ++n;
            leaving = each;
        }
        End end{.vertex = v, .at = plane.at(v), .point = {}, .is_free = n == 1};
        if (n == 1) end.neighbour = solid.end(leaving);
        end.component = components.root(v.index);
        ends.push_back(end);
    }
    std::vector<std::optional<NodeId>> point_at(solid.vertices().n_rows());
    for (std::size_t i = 0; i < drawing.model().points.size(); ++i)
        if (const auto vertex = drawing.vertex(NodeId(i))) point_at[vertex->index] = NodeId(i);
    for (End& end : ends) end.point = point_at[end.vertex.index];
    return ends;
}

double extent_of(const std::vector<End>& ends)
{
    topology::FlatBox box;
    for (const End& end : ends) box.add(end.at);
    return box.diagonal();
}

bool are_same(const std::optional<NodeId>& a, NodeId b) { return a && *a == b; }

/// Every curve that has the one point gets the other in its place.
void replace_point(PlaneModel& model, NodeId gone, NodeId by)
{
    const auto replace = [&](DrawnPlace& place) {
        if (are_same(place.point, gone)) place.point = by;
    };
    for (auto& curve : model.curves) {
        if (!curve.shape) continue;
        std::ranges::for_each(curve.shape->places, replace);
        if (curve.shape->center) replace(*curve.shape->center);
    }
    for (auto& load_case : model.load_cases) {
        for (auto& load : load_case.points)
            if (load.node == gone) load.node = by;
        for (auto& settlement : load_case.settlements)
            if (are_same(settlement.point, gone)) settlement.point = by;
    }
    auto& support = model.points[by.index].support;
    if (!support) support = model.points[gone.index].support;
}

/// A polyline whose two ends are one point is closed.
void close_polylines(PlaneModel& model)
{
    for (auto& curve : model.curves) {
        if (!curve.shape) continue;
        auto& shape = *curve.shape;
        const bool can_close = shape.kind == femoop::plane::DrawnKind::Line ||
                               shape.kind == femoop::plane::DrawnKind::Spline;
        if (!can_close || shape.is_closed || shape.places.size() < 4) continue;
        if (!shape.places.front().point || shape.places.front().point != shape.places.back().point) continue;
        shape.places.pop_back();
        shape.is_closed = true;
    }
}

/// Straight parts from the point to itself go, and a line that has no other part. \returns which curves those are
std::vector<bool> drop_collapsed_parts(PlaneModel& model, NodeId point)
{
    std::vector<bool> gone(model.curves.size());
    for (std::size_t i = 0; i < model.curves.size(); ++i) {
        auto& shape = model.curves[i].shape;
        if (!shape || shape->kind != femoop::plane::DrawnKind::Line) continue;
        auto& places = shape->places;
        const auto is_it = [&](const auto& place) { return place.point == point; };
        const auto rest = std::unique(places.begin(), places.end(),
                                      [&](const auto& a, const auto& b) { return is_it(a) && is_it(b); });
        places.erase(rest, places.end());
        if (shape->is_closed && places.size() > 1 && is_it(places.front()) && is_it(places.back())) places.pop_back();
        gone[i] = places.size() < 2;
    }
    return gone;
}

} // namespace

std::optional<Gap> narrowest_gap(const Drawing& drawing)
{
    const std::vector<End> ends = ends_of(drawing);
    const double near = widest * extent_of(ends);
    std::optional<Gap> gap;
    for (const End& from : ends) {
        if (!from.is_free) continue;
        for (const End& to : ends) {
            if (to.vertex == from.vertex || to.vertex == from.neighbour) continue;
            const double width = topology::distance(from.at, to.at);
            const bool are_of_chain = to.is_free && to.component == from.component;
            if ((width > near && !are_of_chain) || (gap && width >= gap->width)) continue;
            gap = Gap{.from = from.at,
                      .to = to.at,
                      .width = width,
                      .is_narrow = width <= narrow * extent_of(ends),
                      .point_from = from.point,
                      .point_to = to.point};
        }
    }
    return gap;
}

void join_points(Document& document, NodeId gone, NodeId by)
{
    PlaneModel& model = document.model;
    move_point(document, gone, place_of(model, by));
    replace_point(model, gone, by);
    close_polylines(model);
    Erased erased;
    erased.curves = drop_collapsed_parts(model, by);
    erased.points.resize(model.points.size());
    erased.points[gone.index] = true;
    erase_entries(model, erased);
}

void close_gap(Document& document, const Gap& gap)
{
    if (!gap.is_narrow || !gap.point_from) {
        draw_curve(document, {.places = {{gap.from, gap.point_from}, {gap.to, gap.point_to}}});
        return;
    }
    if (gap.point_to) join_points(document, *gap.point_from, *gap.point_to);
    else move_point(document, *gap.point_from, gap.to);
}

} // namespace plane
