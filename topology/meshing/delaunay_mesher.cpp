#include "topology/meshing/delaunay_mesher.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "topology/geometry/predicates.h"

namespace topology {

namespace {

constexpr double largest_circle = 0.77; // its radius over the edge that is wanted; an equilateral triangle has 0.58
constexpr double least_distance = 0.6;  // of a place from others, over the edge that is wanted

double square(double value) { return value * value; }

} // namespace

DelaunayMesher::DelaunayMesher(const MeshDomain& domain, MesherOptions options)
    : domain_(domain),
      triangles_(domain_.triangles()),
      options_(std::move(options)),
      least_chord_(4.0 * square(std::sin(options_.min_angle * std::numbers::pi / 180.0))),
      sizes_(domain_.sizes(options_)),
      n_of_domain_(sizes_.size())
{}

DelaunayMesher::Step DelaunayMesher::next()
{
    if (const auto made = domain_.next()) {
        if (*made == Step::Outside) suspect_all();
        return last_ = *made;
    }
    if (insert_point()) return last_ = Step::Point;
    if (n_sweeps_ >= options_.n_sweeps || !domain_.is_smoothed()) return last_ = Step::Done;
    domain_.smooth(static_cast<Index>(n_of_domain_));
    ++n_sweeps_;
    return last_ = Step::Smoothed;
}

MeshMarks DelaunayMesher::marks() const
{
    MeshMarks marks;
    if (last_ == Step::Node || last_ == Step::Point) marks.places = {triangles_.at(domain_.last_vertex())};
    if (last_ == Step::Edge) marks.edges = {domain_.last_edge()};
    if (last_ != Step::Point) return marks;
    marks.cells = domain_.cells_around(domain_.last_vertex());
    const FlatPoint& a = triangles_.at(asking_[0]);
    const FlatPoint centre = circumcentre(a, triangles_.at(asking_[1]), triangles_.at(asking_[2]));
    marks.circle = MeshMarks::Circle{.centre = centre, .radius = distance(centre, a)};
    return marks;
}

void DelaunayMesher::suspect_all()
{
    for (Index t = 0; t < triangles_.n_triangles(); ++t)
        if (domain_.is_inside(t)) suspect(t);
    most_points_ = domain_.most_points(sizes_, options_);
}

bool DelaunayMesher::is_bad(Index triangle) const
{
    const auto& [i, j, k] = triangles_.vertices(triangle);
    const FlatPoint &a = triangles_.at(i), &b = triangles_.at(j), &c = triangles_.at(k);
    const double ab = dot(b - a, b - a), bc = dot(c - b, c - b), ca = dot(a - c, a - c);
    const double radius = ab * bc * ca / (4.0 * square(turn(a, b, c))); // all squared
    const double wanted = (sizes_[i] + sizes_[j] + sizes_[k]) / 3.0;
    if (radius > square(largest_circle * wanted)) return true;
    return std::min({ab, bc, ca}) < least_chord_ * radius; // the smallest angle's chord
}

void DelaunayMesher::suspect(Index triangle)
{
    if (is_bad(triangle)) suspects_.push_back({triangle, triangles_.vertices(triangle)});
}

/// Puts a place into the next triangle that wants one. False when none is left.
bool DelaunayMesher::insert_point()
{
    while (n_looked_ < suspects_.size()) {
        const Suspect next = suspects_[n_looked_++];
        if (triangles_.vertices(next.triangle) != next.vertices) continue;
        if (triangles_.n_vertices() > most_points_ + n_of_domain_) continue;
        asking_ = next.vertices;
        const auto& [i, j, k] = next.vertices;
        const FlatPoint centre = circumcentre(triangles_.at(i), triangles_.at(j), triangles_.at(k));
        const double wanted = (sizes_[i] + sizes_[j] + sizes_[k]) / 3.0;
        if (try_at(near_shortest_edge(next.triangle, centre), next.triangle, least_distance * wanted)) return true;
        if (try_at(centre, next.triangle, 0.0)) return true;
    }
    suspects_.clear();
    n_looked_ = 0;
    return false;
}

bool DelaunayMesher::try_at(const FlatPoint& at, Index triangle, double least)
{
    const Triangulation::Cavity* const cavity = triangles_.cavity(at, triangle);
    if (cavity == nullptr || cavity->nearest < square(least) || encroaches(at, *cavity)) return false;
    double size = std::numeric_limits<double>::infinity();
    for (const Index corner : cavity->corners) {
        const Index around = triangles_.vertex(Triangulation::next(corner));
        size = std::min(size, sizes_[around] + options_.growth * distance(triangles_.at(around), at));
    }
    triangles_.insert(at);
    sizes_.push_back(options_.limited(size, at));
    domain_.add_inside();
    for (const Index made : cavity->triangles) suspect(made);
    return true;
}

/// Whether a place lies in the circle over an edge that is fixed.
bool DelaunayMesher::encroaches(const FlatPoint& at, const Triangulation::Cavity& cavity) const
{
    return std::any_of(cavity.corners.begin(), cavity.corners.end(), [&](Index corner) {
        if (!triangles_.is_fixed(corner)) return false;
        const FlatPoint& a = triangles_.at(triangles_.vertex(Triangulation::next(corner)));
        const FlatPoint& b = triangles_.at(triangles_.vertex(Triangulation::previous(corner)));
        return dot(a - at, b - at) < 0.0;
    });
}

/// Where a triangle over the shortest edge is equilateral, as far as sizes differ; no farther than the circumcentre.
FlatPoint DelaunayMesher::near_shortest_edge(Index triangle, const FlatPoint& centre) const
{
    const auto& corners = triangles_.vertices(triangle);
    double shortest = std::numeric_limits<double>::infinity();
    FlatPoint foot;
    double wanted = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Index a = corners[i], b = corners[(i + 1) % 3];
        const double squared = dot(triangles_.at(b) - triangles_.at(a), triangles_.at(b) - triangles_.at(a));
        if (squared >= shortest) continue;
        shortest = squared;
        foot = middle(triangles_.at(a), triangles_.at(b));
        wanted = 0.5 * (sizes_[a] + sizes_[b]);
    }
    const double leg = std::clamp(wanted, std::sqrt(shortest), 2.0 * std::sqrt(shortest));
    const double height = std::sqrt(square(leg) - 0.25 * shortest);
    const double reach = distance(centre, foot);
    return reach <= height ? centre : foot + (height / reach) * (centre - foot);
}

} // namespace topology
