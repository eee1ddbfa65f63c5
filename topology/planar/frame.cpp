#include "topology/planar/frame.h"

#include <algorithm>
#include <cmath>

namespace topology {

namespace {

constexpr double tolerance = 1e-9; // of the extent

Vector unit(const Vector& a) { return 1.0 / length(a) * a; }

/// The vertex that is farthest by a measure, and its measure.
template <class Measure> std::pair<Point, double> farthest(const Solid& solid, const Measure& measure)
{
    std::pair<Point, double> best{solid.point(*solid.vertices().begin()), 0.0};
    for (const VertexId v : solid.vertices())
        if (const double m = measure(solid.point(v)); m > best.second) best = {solid.point(v), m};
    return best;
}

/// The normal turned so that its last coordinate that is not 0 is positive.
Vector toward_viewer(const Vector& n)
{
    const double decisive = std::abs(n.z) > tolerance ? n.z : std::abs(n.y) > tolerance ? n.y : n.x;
    return decisive < 0.0 ? -1.0 * n : n;
}

/// A plane along `along` that is level if that is.
Vector any_normal(const Vector& along)
{
    const bool is_upright = std::abs(along.x) + std::abs(along.y) < tolerance * std::abs(along.z);
    const Vector side = is_upright ? Vector{1.0, 0.0, 0.0} : cross({0.0, 0.0, 1.0}, along);
    return cross(along, side);
}

} // namespace

Frame frame_across(const Point& origin, const Vector& normal)
{
    const Vector n = unit(normal);
    if (n.z > 1.0 - tolerance) return {.origin = origin};
    if (n.z < tolerance - 1.0) return {.origin = origin, .u = {1.0, 0.0, 0.0}, .v = {0.0, -1.0, 0.0}};
    const Vector u = unit(cross({0.0, 0.0, 1.0}, n));
    return {origin, u, cross(n, u)};
}

std::optional<Frame> plane_of(const Solid& solid)
{
    if (solid.is_empty()) return std::nullopt;
    const Point origin = solid.point(*solid.vertices().begin());
    const auto [end, extent] = farthest(solid, [&](const Point& p) { return length(p - origin); });
    if (extent == 0.0) return Frame{.origin = origin};
    const Vector along = unit(end - origin);
    const auto [side, width] = farthest(solid, [&](const Point& p) { return length(cross(along, p - origin)); });
    const bool is_line = width <= tolerance * extent;
    const Vector normal = unit(is_line ? any_normal(along) : cross(along, side - origin));
    const Frame found = frame_across(origin, toward_viewer(normal));
    const Vector n = found.normal();
    const double depth = farthest(solid, [&](const Point& p) { return std::abs(dot(n, p - origin)); }).second;
    return depth <= tolerance * extent ? std::optional(found) : std::nullopt;
}

} // namespace topology
