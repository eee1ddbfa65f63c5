#include "topology/meshing/front_mesher.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "topology/geometry/predicates.h"

namespace topology {

namespace {

constexpr double shortest_leg = 0.75, longest_leg = 1.5; // of a new triangle, over its edge of the front
constexpr double least_clearance = 0.65;                 // of a place from nodes, over the edge that is wanted
constexpr double largest_radius = 0.77; // of a triangle's circle, likewise; an equilateral triangle has 0.58
constexpr double least_height = 0.4;    // of a new triangle, over its edge of the front

} // namespace

FrontMesher::FrontMesher(const MeshDomain& domain, MesherOptions options)
    : domain_(domain),
      triangles_(domain_.triangles()),
      options_(std::move(options)),
      sizes_(domain_.sizes(options_)),
      n_of_domain_(sizes_.size())
{}

FrontMesher::Step FrontMesher::next()
{
    if (const auto made = domain_.next()) {
        if (*made == Step::Outside) start();
        return last_ = *made;
    }
    const std::size_t n_before = triangles_.n_vertices();
    if (!is_closed_ && advance())
        return last_ = triangles_.n_vertices() > n_before ? Step::FrontPoint : Step::FrontNode;
    if (!std::exchange(is_closed_, true)) release();
    if (n_sweeps_ >= options_.n_sweeps || !domain_.is_smoothed()) return last_ = Step::Done;
    domain_.smooth(static_cast<Index>(n_of_domain_));
    ++n_sweeps_;
    return last_ = Step::Smoothed;
}

/// Loops have the domain on one side, segments on both.
void FrontMesher::start()
{
    most_points_ = domain_.most_points(sizes_, options_);
    for (Index t = 0; t < triangles_.n_triangles(); ++t) is_done_.push_back(!domain_.is_inside(t));
    const std::vector<CellEdge>& edges = domain_.edges();
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Index a = DomainTriangulation::vertex(edges[i][0]), b = DomainTriangulation::vertex(edges[i][1]);
        push(a, b);
        if (i >= domain_.n_of_loops()) push(b, a);
    }
}

void FrontMesher::push(Index a, Index b)
{
    const FlatVector along = triangles_.at(b) - triangles_.at(a);
    front_.push_back({.squared = dot(along, along), .a = a, .b = b});
    std::push_heap(front_.begin(), front_.end(), std::greater<>()); // the least on top
}

bool FrontMesher::is_open(const FrontEdge& edge) const
{
    return !is_done_[*triangles_.triangle_left_of(edge.a, edge.b)];
}

/// One triangle over the shortest edge. False where the front has closed.
bool FrontMesher::advance()
{
    while (!front_.empty()) {
        std::pop_heap(front_.begin(), front_.end(), std::greater<>());
        const FrontEdge edge = front_.back();
        front_.pop_back();
        if (!is_open(edge)) continue;
        put_place(edge, *triangles_.triangle_left_of(edge.a, edge.b));
        close(*triangles_.triangle_left_of(edge.a, edge.b), edge);
        return true;
    }
    return false;
}

/// The apex of an isosceles triangle to the left of the edge.
FlatPoint FrontMesher::ideal_place(const FrontEdge& edge) const
{
    const FlatPoint &a = triangles_.at(edge.a), &b = triangles_.at(edge.b);
    const FlatVector along = b - a;
    const double base = length(along), wanted = 0.5 * (sizes_[edge.a] + sizes_[edge.b]);
    const double leg = std::clamp(wanted, shortest_leg * base, longest_leg * base);
    const double height = std::sqrt(leg * leg - 0.25 * base * base);
    return middle(a, b) + (height / base) * FlatVector{-along.y, along.x};
}

double FrontMesher::size_at(const FlatPoint& at, const Triangulation::Cavity& cavity) const
{
    double size = std::numeric_limits<double>::infinity();
    for (const Index corner : cavity.corners) {
        const Index around = triangles_.vertex(Triangulation::next(corner));
        size = std::min(size, sizes_[around] + options_.growth * distance(triangles_.at(around), at));
    }
    return options_.limited(size, at);
}

/// Whether a place is far enough from all nodes, and in the circle over no edge of the front but its own.
bool FrontMesher::is_clear(const FlatPoint& at, const FrontEdge& edge, const Triangulation::Cavity& cavity) const
{
    const double least = least_clearance *
                         std::min(0.5 * (sizes_[edge.a] + sizes_[edge.b]), longest_leg * std::sqrt(edge.squared));
    if (cavity.nearest < least * least) return false;
    return std::none_of(cavity.corners.begin(), cavity.corners.end(), [&](Index corner) {
        if (!triangles_.is_fixed(corner)) return false;
        const Index u = triangles_.vertex(Triangulation::next(corner)),
                    v = triangles_.vertex(Triangulation::previous(corner));
        return (u != edge.a || v != edge.b) && dot(triangles_.at(u) - at, triangles_.at(v) - at) < 0.0;
    });
}

/// The ideal place, or where that is too near to others and the triangle to the node that stands would be too large, the
/// middle of its circle.
bool FrontMesher::put_place(const FrontEdge& edge, Index triangle)
{
    if (triangles_.n_vertices() > most_points_ + n_of_domain_) return false;
    if (try_at(ideal_place(edge), edge, triangle)) return true;
    const auto& [i, j, k] = triangles_.vertices(triangle);
    const FlatPoint &a = triangles_.at(edge.a), &b = triangles_.at(edge.b);
    const FlatPoint centre = circumcentre(triangles_.at(i), triangles_.at(j), triangles_.at(k));
    const double wanted = 0.5 * (sizes_[edge.a] + sizes_[edge.b]);
    const bool is_large = distance(centre, a) > largest_radius * wanted;
    const bool is_above = turn(a, b, centre) > least_height * edge.squared; // the edge times a height
    return is_large && is_above && try_at(centre, edge, triangle);
}

/// A place in the circle of the triangle over the edge makes a triangle with it.
bool FrontMesher::try_at(const FlatPoint& at, const FrontEdge& edge, Index triangle)
{
    const auto& [a, b, c] = triangles_.vertices(triangle);
    if (in_circle(triangles_.at(a), triangles_.at(b), triangles_.at(c), at) <= 0.0) return false;
    const Triangulation::Cavity* const cavity = triangles_.cavity(at, triangle);
    if (cavity == nullptr || !is_clear(at, edge, *cavity)) return false;
    sizes_.push_back(size_at(at, *cavity));
    triangles_.insert(at);
    domain_.add_inside();
    is_done_.resize(triangles_.n_triangles(), false);
    return true;
}

/// The triangle is behind the front now: its edges that were not of the front are.
void FrontMesher::close(Index triangle, const FrontEdge& edge)
{
    chosen_ = edge;
    last_triangle_ = triangle;
    is_done_[triangle] = true;
    for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
        if (triangles_.is_fixed(corner)) continue;
        const Index a = triangles_.vertex(Triangulation::previous(corner)),
                    b = triangles_.vertex(Triangulation::next(corner));
        triangles_.fix(a, b);
        made_.push_back({.squared = 0.0, .a = a, .b = b});
        push(a, b);
    }
}

void FrontMesher::release()
{
    for (const FrontEdge& edge : made_) triangles_.release(edge.a, edge.b);
    made_.clear();
    triangles_.restore();
}

std::vector<CellEdge> FrontMesher::front() const
{
    std::vector<CellEdge> edges;
    for (const FrontEdge& edge : front_)
        if (is_open(edge)) edges.push_back({DomainTriangulation::node(edge.a), DomainTriangulation::node(edge.b)});
    return edges;
}

CellMesh FrontMesher::mesh() const
{
    CellMesh mesh = domain_.mesh();
    if (is_closed_ || is_done_.empty()) return mesh;
    mesh.cells.clear();
    for (Index t = 0; t < is_done_.size(); ++t) {
        const auto& [a, b, c] = triangles_.vertices(t);
        if (is_done_[t] && domain_.is_inside(t))
            mesh.cells.emplace_back(DomainTriangulation::node(a), DomainTriangulation::node(b),
                                    DomainTriangulation::node(c));
    }
    return mesh;
}

MeshMarks FrontMesher::marks() const
{
    MeshMarks marks;
    const auto at = [&](CellNode node) { return triangles_.at(DomainTriangulation::vertex(node)); };
    for (const auto& [a, b] : front()) marks.lines.push_back({at(a), at(b)});
    if (last_ == Step::Node || last_ == Step::FrontPoint) marks.places = {triangles_.at(domain_.last_vertex())};
    if (last_ == Step::Edge) marks.edges = {domain_.last_edge()};
    if (last_ != Step::FrontPoint && last_ != Step::FrontNode) return marks;
    marks.edges = {{triangles_.at(chosen_.a), triangles_.at(chosen_.b)}};
    marks.cells = {domain_.corners(last_triangle_)};
    return marks;
}

} // namespace topology
