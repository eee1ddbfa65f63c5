#include "apps/euler/view/polygons/plane_layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace euler {

using topology::FaceId;
using topology::HalfEdgeId;
using topology::LoopId;

namespace {

using std::numbers::pi;
constexpr double between_faces = 0.5; // two faces, where the polygon of one without rings has the radius 1
constexpr double with_rings = 1.8;    // radius of the others
constexpr double columns_per_row = 1.6;
constexpr int n_of_circle = 48;

int n_sides(const topology::Solid& solid, LoopId l)
{
    if (solid.is_lone(l)) return 0;
    int n = 0;
    for ([[maybe_unused]] const HalfEdgeId h : solid.chain(l)) ++n;
    return n;
}

std::size_t n_loops(const topology::Solid& solid, FaceId f)
{
    std::size_t n = 0;
    for ([[maybe_unused]] const LoopId l : solid.loops(f)) ++n;
    return n;
}

ui::World2 between_two(ui::World2 a, ui::World2 b, double t) { return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; }

/// Of a side of the polygon, so far inside its face.
ui::World2 inside(const Polygon& polygon, int i, double t, double aside)
{
    if (polygon.n == 0) return polygon.middle;
    return polygon.at(i, t, polygon.is_ring ? 1.0 + aside : 1.0 - aside);
}

} // namespace

ui::World2 Polygon::at(int i, double share, double factor) const
{
    if (n <= 2) return on_circle(i + share, factor);
    return between_two(on_circle(i, factor), on_circle(i + 1, factor), share);
}

double Polygon::inner_radius() const { return n <= 2 ? radius : radius * std::cos(pi / n); }

int Polygon::n_points() const { return n <= 2 ? n_of_circle / std::max(1, n) : 1; }

ui::World2 Polygon::on_circle(double i, double factor) const
{
    const double turn = 2.0 * pi / std::max(1, n), sense = is_ring ? -1.0 : 1.0;
    const double angle = -0.5 * pi + sense * turn * (i - 0.5);
    return {middle.x + factor * radius * std::cos(angle), middle.y + factor * radius * std::sin(angle)};
}

PlaneLayout::PlaneLayout(std::span<const Subject> subjects)
{
    const std::vector<Place> places = face_places(subjects);
    std::size_t next = 0;
    for (const Subject& subject : subjects) {
        Solid& in = solids_.emplace_back(Solid{subject.solid});
        in.polygons.resize(subject.solid->loops().n_rows());
        in.sides.resize(subject.solid->half_edges().n_rows());
        for (const FaceId f : subject.solid->faces()) add(in, f, places[next++]);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Place& place = places[i];
        const ui::Box box{{place.middle.x - place.radius, place.middle.y - place.radius},
                          {place.middle.x + place.radius, place.middle.y + place.radius}};
        bounds_ = i == 0 ? box : ui::united(bounds_, box);
    }
}

std::optional<int> PlaneLayout::side(std::size_t subject, HalfEdgeId h) const
{
    return has(subject) && solid(subject).has(h) ? std::optional(solids_[subject].sides[h.index]) : std::nullopt;
}

void PlaneLayout::add(Solid& to, FaceId f, const Place& place)
{
    const topology::Solid& solid = *to.solid;
    Face& face = to.faces.emplace_back(Face{f, {}, {}});
    for (const LoopId l : solid.loops(f)) face.loops.push_back(l);
    const int n = n_sides(solid, face.loops.front());
    const bool is_dot = n == 0; // a lone vertex on the rest of a sphere, whose rim is no edge
    face.outline = {place.middle, place.radius, is_dot ? 1 : n, false};
    const std::size_t n_outlines = is_dot ? 0 : 1, n_inside = face.loops.size() - n_outlines;
    if (!is_dot) to.polygons[face.loops.front().index] = face.outline;
    for (std::size_t k = 0; k < n_inside; ++k) {
        const Place ring = ring_place({place.middle, face.outline.inner_radius()}, k, n_inside);
        const LoopId l = face.loops[k + n_outlines];
        to.polygons[l.index] = {ring.middle, ring.radius, n_sides(solid, l), true};
    }
    for (const LoopId l : face.loops) {
        int i = 0;
        for (const HalfEdgeId h : solid.chain(l)) to.sides[h.index] = i++;
    }
}

/// Of the k-th of n rings, within a circle.
PlaneLayout::Place PlaneLayout::ring_place(const Place& room, std::size_t k, std::size_t n)
{
    if (n == 1) return {room.middle, 0.5 * room.radius};
    const double angle = 0.5 * pi + 2.0 * pi * static_cast<double>(k) / static_cast<double>(n);
    const double away = 0.55 * room.radius;
    const double radius = std::min(0.3 * room.radius, 0.7 * away * std::sin(pi / static_cast<double>(n)));
    return {{room.middle.x + away * std::cos(angle), room.middle.y + away * std::sin(angle)}, radius};
}

/// Those with rings are larger, so that there is room inside.
std::vector<PlaneLayout::Place> PlaneLayout::face_places(std::span<const Subject> subjects)
{
    std::vector<Place> places;
    double area = 0.0;
    for (const Subject& subject : subjects)
        for (const FaceId f : subject.solid->faces()) {
            const bool has_rings = n_loops(*subject.solid, f) > 1;
            places.push_back({{}, has_rings ? with_rings : 1.0});
            area += std::pow(2.0 * places.back().radius + between_faces, 2);
        }
    const double width = std::sqrt(columns_per_row * area);
    double x = 0.0, y = 0.0, height = 0.0;
    for (std::size_t i = 0; i < places.size();) {
        std::size_t end = i;
        for (x = 0.0, height = 0.0; end < places.size() && (end == i || x + places[end].radius < width); ++end) {
            places[end].middle.x = x + places[end].radius;
            x += 2.0 * places[end].radius + between_faces;
            height = std::max(height, 2.0 * places[end].radius);
        }
        for (; i < end; ++i) places[i].middle.y = y - 0.5 * height;
        y -= height + between_faces;
    }
    return places;
}

ui::World2 PlaneOnItsWay::at(std::size_t subject, HalfEdgeId h, double t, double aside) const
{
    const Polygon& polygon = drawn_.polygon(subject, drawn_.solid(subject).loop(h));
    const ui::World2 own = inside(polygon, *drawn_.side(subject, h), t, aside);
    return rests() ? own : between_two(there(subject, h, t, aside), own, share_);
}

int PlaneOnItsWay::n_points(std::size_t subject, HalfEdgeId h) const
{
    const int own = drawn_.polygon(subject, drawn_.solid(subject).loop(h)).n_points();
    if (rests() || !other_->side(subject, h)) return own;
    return std::max(own, other_->polygon(subject, other_->solid(subject).loop(h)).n_points());
}

ui::World2 PlaneOnItsWay::there(std::size_t subject, HalfEdgeId h, double t, double aside) const
{
    if (const auto i = other_->side(subject, h))
        return inside(other_->polygon(subject, other_->solid(subject).loop(h)), *i, t, aside);
    const auto from = neighbour(subject, h, false, aside), to = neighbour(subject, h, true, aside);
    if (from && to) return between_two(*from, *to, t);
    if (const auto vertex = old_vertex(subject, h, aside)) return *vertex;
    return drawn_.polygon(subject, drawn_.solid(subject).loop(h)).middle; // out of nothing
}

/// Where the nearest half-edge along the loop that stands there too begins, or ends.
std::optional<ui::World2> PlaneOnItsWay::neighbour(std::size_t subject, HalfEdgeId h, bool is_next, double aside) const
{
    const topology::Solid& solid = drawn_.solid(subject);
    for (HalfEdgeId g = is_next ? solid.next(h) : solid.prev(h); g != h; g = is_next ? solid.next(g) : solid.prev(g))
        if (const auto i = other_->side(subject, g))
            return inside(other_->polygon(subject, other_->solid(subject).loop(g)), *i, is_next ? 0.0 : 1.0, aside);
    return std::nullopt;
}

std::optional<ui::World2> PlaneOnItsWay::old_vertex(std::size_t subject, HalfEdgeId h, double aside) const
{
    const topology::Solid& solid = drawn_.solid(subject);
    for (const topology::VertexId v : {solid.start(h), solid.end(h)}) {
        if (!other_->has(subject) || !other_->solid(subject).has(v)) continue;
        const HalfEdgeId g = other_->solid(subject).half_edge(v);
        return inside(other_->polygon(subject, other_->solid(subject).loop(g)), *other_->side(subject, g), 0.0, aside);
    }
    return std::nullopt;
}

} // namespace euler
