#include "apps/euler/view/solid/half_edge_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace euler {

using topology::EdgeId;
using topology::HalfEdgeId;
using topology::Point;
using topology::VertexId;

namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr int n_of_curve = 48;
constexpr double least_reach = 80.0, more_reach = 70.0; // [px] of a curve's control points
constexpr double alone = 40.0;                          // such reaches to the world's unit, where all lies at one point
constexpr double least_half = 0.35, most_half = 0.9;    // [rad] between a curve's ends, half

/// An angle for every half-edge of a fan that turns clockwise: those without direction share the room between the
/// others evenly.
std::vector<double> angles_of(const std::vector<std::optional<double>>& known)
{
    const std::size_t n = known.size();
    std::size_t first = 0;
    while (first < n && !known[first]) ++first;
    std::vector<double> angles(n);
    if (first == n) {
        for (std::size_t i = 0; i < n; ++i)
            angles[i] = 0.25 * turn - turn * static_cast<double>(i) / static_cast<double>(n);
        return angles;
    }
    for (std::size_t i = first; i < first + n;) {
        std::size_t next = i + 1;
        while (!known[next % n]) ++next;
        const double from = *known[i % n], room = from - *known[next % n];
        const double clockwise = room > 0.0 ? room : room + turn * (1.0 + std::floor(-room / turn));
        for (std::size_t k = i; k < next; ++k)
            angles[k % n] = from - clockwise * static_cast<double>(k - i) / static_cast<double>(next - i);
        i = next;
    }
    return angles;
}

Point bezier(const Point& p, const topology::Vector& a, const topology::Vector& b, double t)
{
    return p + (3.0 * (1.0 - t) * (1.0 - t) * t) * a + (3.0 * (1.0 - t) * t * t) * b;
}

} // namespace

HalfEdgePaths::HalfEdgePaths(const topology::Solid& solid, const AnimatedPositions& positions,
                             const ViewTransform& transform)
    : solid_(solid), positions_(positions), transform_(transform)
{
    for (const EdgeId e : solid.edges()) {
        const VertexId v = solid.start(solid.plus(e));
        if (v == solid.start(solid.minus(e)) && !curves_.contains(e)) bend(v);
    }
}

void HalfEdgePaths::bend(VertexId v)
{
    std::vector<std::optional<double>> known;
    std::unordered_map<HalfEdgeId, std::size_t> places;
    for (const HalfEdgeId h : solid_.fan(v)) {
        places[h] = known.size();
        const bool is_closed = solid_.end(h) == v;
        known.push_back(is_closed ? std::nullopt
                                  : std::optional(transform_.angle(positions_[solid_.end(h)] - positions_[v])));
    }
    const std::vector<double> angles = angles_of(known);
    for (const auto& [h, place] : places)
        if (solid_.end(h) == v && solid_.plus(*solid_.edge(h)) == h)
            curves_[*solid_.edge(h)] = curve(v, angles[place], angles[places.at(solid_.mate(h))]);
}

Curve HalfEdgePaths::curve(VertexId v, double leaves_at, double returns_at) const
{
    const double apart = std::remainder(returns_at - leaves_at, turn);
    const double middle = leaves_at + 0.5 * apart;
    const double half = std::copysign(std::clamp(0.5 * std::abs(apart), least_half, most_half), apart);
    const double size = least_reach + more_reach * std::abs(apart) / turn;
    const double reach = positions_.extent() > 0.0 ? transform_.px(size) : size / alone;
    const topology::Vector a = reach * transform_.across(middle - half), b = reach * transform_.across(middle + half);
    Curve points;
    for (int i = 0; i <= n_of_curve; ++i) points.push_back(bezier(positions_[v], a, b, double{1.0} * i / n_of_curve));
    return points;
}

bool HalfEdgePaths::is_curved(HalfEdgeId h) const
{
    if (curves_.empty()) return false;
    const auto e = solid_.edge(h);
    return e && curves_.contains(*e);
}

std::vector<Point> HalfEdgePaths::operator()(HalfEdgeId h) const
{
    const auto e = solid_.edge(h);
    if (!e) return {positions_[solid_.start(h)]};
    const auto found = curves_.find(*e);
    if (found == curves_.end()) return {positions_[solid_.start(h)], positions_[solid_.end(h)]};
    std::vector<Point> path = found->second;
    if (solid_.plus(*e) != h) std::reverse(path.begin(), path.end());
    return path;
}

} // namespace euler
