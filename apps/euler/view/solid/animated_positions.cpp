#include "apps/euler/view/solid/animated_positions.h"

#include <algorithm>
#include <numbers>
#include <optional>

namespace euler {

using topology::EdgeId;
using topology::HalfEdgeId;
using topology::Point;
using topology::VertexId;

namespace {

constexpr double null_edge = 26.0;                              // [px] as which an edge without length is drawn
constexpr double golden_angle = 2.0 * std::numbers::pi * 0.382; // spreads any number of directions evenly

Point between(const Point& a, const Point& b, double t) { return a + t * (b - a); }

/// The vertex out of which v grows.
std::optional<VertexId> root(const topology::Solid& solid, const MarkTable& marks, VertexId v)
{
    for (const HalfEdgeId h : solid.fan(v)) {
        const auto e = solid.edge(h);
        if (e && marks.presence(*e) < 1.0 && solid.end(h) != v) return solid.end(h);
    }
    return std::nullopt;
}

} // namespace

double extent(const topology::Solid& solid)
{
    std::optional<Point> least, most;
    for (const VertexId v : solid.vertices()) {
        const Point& p = solid.point(v);
        least = least ? Point{std::min(least->x, p.x), std::min(least->y, p.y), std::min(least->z, p.z)} : p;
        most = most ? Point{std::max(most->x, p.x), std::max(most->y, p.y), std::max(most->z, p.z)} : p;
    }
    return least ? length(*most - *least) : 0.0;
}

AnimatedPositions::AnimatedPositions(const topology::Solid& solid, const MarkTable& marks,
                                     const ViewTransform& transform)
    : points_(solid.vertices().n_rows()), extent_(euler::extent(solid))
{
    for (const VertexId v : solid.vertices()) points_[v.index] = solid.point(v);
    spread_null_edges(solid, transform);
    if (!marks.is_empty()) move_partial(solid, marks);
}

void AnimatedPositions::spread_null_edges(const topology::Solid& solid, const ViewTransform& transform)
{
    int n_spread = 0;
    for (const EdgeId e : solid.edges()) {
        const VertexId a = solid.start(solid.plus(e)), b = solid.start(solid.minus(e));
        if (a == b || length(solid.point(a) - solid.point(b)) > 1e-9 * extent_) continue;
        const VertexId newer = std::max(a, b);
        points_[newer.index] = points_[std::min(a, b).index] +
                               transform.px(null_edge) * transform.across(0.4 + golden_angle * n_spread++);
    }
}

void AnimatedPositions::move_partial(const topology::Solid& solid, const MarkTable& marks)
{
    const std::vector<Point> whole = points_;
    for (const VertexId v : solid.vertices()) {
        const double presence = marks.presence(v);
        if (presence >= 1.0) continue;
        if (const auto from = root(solid, marks, v))
            points_[v.index] = between(whole[from->index], whole[v.index], presence);
    }
}

} // namespace euler
