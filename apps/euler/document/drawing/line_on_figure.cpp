#include "apps/euler/document/drawing/line_on_figure.h"

#include <algorithm>
#include <cmath>

namespace euler {

using topology::EdgeId;
using topology::FlatPoint;
using topology::HalfEdgeId;
using topology::Point;
using topology::VertexId;

LineOnFigure::LineOnFigure(const topology::Solid& solid, const topology::Frame& frame, const Point& from,
                           const Point& to)
    : solid_(solid), frame_(frame), from_(from), to_(to), a_(frame.flat(from)), b_(frame.flat(to))
{
    double extent = length(to - from);
    for (const VertexId v : solid.vertices()) extent = std::max(extent, length(solid.point(v) - from));
    tolerance_ = 1e-9 * extent;
}

/// How far p is beside the line through a and b, to the left; 0 within the tolerance.
double LineOnFigure::beside(const FlatPoint& a, const FlatPoint& b, const FlatPoint& p) const
{
    const double distance = turn(a, b, p) / std::hypot(b.x - a.x, b.y - a.y);
    return std::abs(distance) <= tolerance_ ? 0.0 : distance;
}

bool LineOnFigure::is_at(const FlatPoint& a, const FlatPoint& b) const
{
    return std::hypot(a.x - b.x, a.y - b.y) <= tolerance_;
}

double LineOnFigure::along(const FlatPoint& p) const
{
    const double x = b_.x - a_.x, y = b_.y - a_.y;
    return ((p.x - a_.x) * x + (p.y - a_.y) * y) / (x * x + y * y);
}

/// Does the vertex lie on the line, ends included?
bool LineOnFigure::is_met(VertexId v) const
{
    const FlatPoint p = flat(v);
    const double t = along(p);
    return is_at(a_, p) || is_at(b_, p) || (beside(a_, b_, p) == 0.0 && t > 0.0 && t < 1.0);
}

/// Does the point lie on the edge, ends excluded?
bool LineOnFigure::is_inside(const FlatPoint& point, HalfEdgeId h) const
{
    const FlatPoint p = flat(solid_.start(h)), q = flat(solid_.end(h));
    if (is_at(p, q) || is_at(p, point) || is_at(q, point) || beside(p, q, point) != 0.0) return false;
    return (point.x - p.x) * (point.x - q.x) + (point.y - p.y) * (point.y - q.y) < 0.0; // p and q on two sides of it
}

/// The place on the line where it meets the inside of an edge.
std::optional<double> LineOnFigure::crossing(HalfEdgeId h) const
{
    if (is_inside(a_, h)) return 0.0;
    if (is_inside(b_, h)) return 1.0;
    const FlatPoint p = flat(solid_.start(h)), q = flat(solid_.end(h));
    if (is_at(p, q) || is_met(solid_.start(h)) || is_met(solid_.end(h))) return std::nullopt;
    const double of_p = beside(a_, b_, p), of_q = beside(a_, b_, q), of_a = beside(p, q, a_), of_b = beside(p, q, b_);
    if (of_p * of_q >= 0.0 || of_a * of_b >= 0.0) return std::nullopt;
    return of_a / (of_a - of_b);
}

std::optional<Crossing> LineOnFigure::crossing() const
{
    for (const EdgeId e : solid_.edges())
        if (const auto t = crossing(solid_.minus(e))) return Crossing{e, *t == 1.0 ? to_ : from_ + *t * (to_ - from_)};
    return std::nullopt;
}

std::vector<Stop> LineOnFigure::stops() const
{
    std::vector<Stop> all;
    for (const VertexId v : solid_.vertices())
        if (is_met(v)) all.push_back({along(flat(v)), v});
    std::sort(all.begin(), all.end(), [](const Stop& a, const Stop& b) { return a.along < b.along; });
    const bool begins_free = all.empty() || !is_at(a_, flat(*all.front().vertex));
    const bool ends_free = all.empty() || !is_at(b_, flat(*all.back().vertex));
    if (begins_free) all.insert(all.begin(), Stop{.along = 0.0, .vertex = std::nullopt});
    if (ends_free) all.push_back({.along = 1.0, .vertex = std::nullopt});
    return all;
}

} // namespace euler
