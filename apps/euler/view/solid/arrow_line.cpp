#include "apps/euler/view/solid/arrow_line.h"

#include "apps/euler/view/shapes/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace euler {

using topology::FaceId;
using topology::HalfEdgeId;
using topology::Point;
using topology::Vector;

namespace {

using std::numbers::pi;
constexpr double beside_edge = 11.0;      // [px]
constexpr double around_lone = 18.0;      // [px]
constexpr double inside_factor = 1.6;     // times as far from the edge, of a face that is seen from inside
constexpr double shortest = 18.0;         // [px] of a line with a head
constexpr double shortest_of_many = 60.0; // likewise, of a solid of thousands of edges
constexpr double gap = 3.0;               // [px] to the neighbour's line
constexpr double least_slant = 0.3;       // sine between an edge and its face's normal

Vector unit(const Vector& v)
{
    const double l = length(v);
    return l > 0.0 ? (1.0 / l) * v : Vector{};
}

} // namespace

ArrowLines::ArrowLines(const topology::Solid& solid, const HalfEdgePaths& paths, const FaceBodies& bodies,
                       const ViewTransform& transform, double symbol_scale)
    : solid_(solid),
      paths_(paths),
      bodies_(bodies),
      transform_(transform),
      symbol_scale_(symbol_scale),
      shortest_(std::lerp(shortest, shortest_of_many, thinning(solid.edges().n_living())))
{}

double ArrowLines::offset(FaceId f) const
{
    constexpr double most_of_room = 0.4;
    const bool is_back = dot(bodies_[f].normal, transform_.toward_eye()) < 0.0;
    const double wanted = transform_.px(beside_edge * symbol_scale_ * (is_back ? inside_factor : 1.0));
    const double radius = bodies_[f].inner_radius;
    return radius > 0.0 ? std::min(wanted, most_of_room * radius) : wanted;
}

Vector ArrowLines::plane_normal(FaceId f, const Vector& along) const
{
    const Vector& normal = bodies_[f].normal;
    return length(cross(normal, along)) > least_slant ? normal : transform_.toward_eye();
}

Vector ArrowLines::direction(HalfEdgeId h) const { return unit(paths_.end(h) - paths_.start(h)); }

double ArrowLines::taken(const Vector& from, const Vector& to, const Vector& normal, double offset)
{
    const double turn = std::atan2(dot(normal, cross(from, to)), dot(from, to));
    if (turn <= 0.0 || turn > 0.98 * pi) return 0.0; // round the outside of a corner, or of a strut's end
    return offset * std::tan(0.5 * turn);
}

std::vector<Point> ArrowLines::straight(HalfEdgeId h) const
{
    const FaceId f = solid_.face(h);
    const Vector whole = paths_.end(h) - paths_.start(h), along = unit(whole);
    const Vector normal = plane_normal(f, along);
    const double aside = offset(f), room = length(whole), least_gap = transform_.px(gap);
    double before = taken(direction(solid_.prev(h)), along, normal, aside) + least_gap;
    double after = taken(along, direction(solid_.next(h)), normal, aside) + least_gap;
    const double shrink = std::min(1.0, 0.7 * room / (before + after));
    before *= shrink;
    after *= shrink;
    const Vector inward = aside * unit(cross(normal, along));
    return {paths_.start(h) + inward + before * along, paths_.end(h) + inward + (-after) * along};
}

/// Beside a curve in the sheet's plane, on its left.
std::vector<Point> ArrowLines::curved(std::vector<Point> path) const
{
    const double aside = transform_.px(beside_edge * symbol_scale_);
    std::vector<Point> line;
    const std::size_t ends = path.size() / 6; // where both its ends meet at the vertex
    for (std::size_t i = ends; i + ends < path.size(); ++i) {
        const Vector along = path[i + 1] - path[i - 1];
        line.push_back(path[i] + aside * unit(cross(transform_.toward_eye(), along)));
    }
    return line;
}

std::vector<Point> ArrowLines::circle(const Point& middle) const
{
    constexpr int n = 20;
    std::vector<Point> line;
    for (int i = 0; i <= n; ++i)
        line.push_back(middle +
                       transform_.px(around_lone * symbol_scale_) * transform_.across(pi * (0.6 + 1.7 * i / n)));
    return line;
}

std::vector<Point> ArrowLines::operator()(HalfEdgeId h) const
{
    if (!solid_.edge(h)) return circle(paths_.start(h));
    if (paths_.is_curved(h)) return curved(paths_(h));
    const double on_sheet = ui::distance(transform_.to_sheet(paths_.start(h)), transform_.to_sheet(paths_.end(h)));
    return on_sheet < shortest_ * symbol_scale_ ? std::vector<Point>{} : straight(h);
}

void keep_share(std::vector<Point>& line, double share)
{
    if (share >= 1.0) return;
    double left = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) left += length(line[i + 1] - line[i]);
    left *= std::max(0.0, share);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double here = length(line[i + 1] - line[i]);
        if (here < left) {
            left -= here;
            continue;
        }
        line[i + 1] = line[i] + (here > 0.0 ? left / here : 0.0) * (line[i + 1] - line[i]);
        line.resize(i + 2);
        return;
    }
}

} // namespace euler
