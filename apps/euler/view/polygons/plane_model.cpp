#include "apps/euler/view/polygons/plane_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace euler {

using topology::FaceId;
using topology::HalfEdgeId;
using topology::LoopId;
using topology::Solid;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double between = 0.5;    // two faces, where the polygon of one without rings has the radius 1
constexpr double with_rings = 1.8; // radius of the others
constexpr double columns_per_row = 1.6;
constexpr double beside_side = 11.0; // [px]
constexpr double gap = 4.0;          // [px] between a half-edge's line and the next one's
constexpr int n_of_circle = 48;

/// Where a loop is drawn: a regular polygon, or a circle where it has one half-edge or two.
struct Polygon {
    ui::World2 middle;
    double radius = 1.0;
    int n = 0;            ///< of half-edges; 0 of a lone vertex
    bool is_ring = false; ///< runs clockwise, its face around it

    /// At side i and a share of it, on the polygon `factor` times as large.
    ui::World2 at(int i, double share, double factor = 1.0) const
    {
        if (n <= 2) return on_circle(i + share, factor);
        const ui::World2 a = on_circle(i, factor), b = on_circle(i + 1, factor);
        return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    }
    double inner_radius() const { return n <= 2 ? radius : radius * std::cos(pi / n); }
    int n_points() const { return n <= 2 ? n_of_circle / std::max(1, n) : 1; } ///< of a side

private:
    ui::World2 on_circle(double i, double factor) const
    {
        const double turn = 2.0 * pi / std::max(1, n), sense = is_ring ? -1.0 : 1.0;
        const double angle = -0.5 * pi + sense * turn * (i - 0.5);
        return {middle.x + factor * radius * std::cos(angle), middle.y + factor * radius * std::sin(angle)};
    }
};

int n_sides(const Solid& solid, LoopId l)
{
    if (solid.is_lone(l)) return 0;
    int n = 0;
    for ([[maybe_unused]] const HalfEdgeId h : solid.chain(l)) ++n;
    return n;
}

struct Place {
    ui::World2 middle;
    double radius;
};

std::size_t n_loops(const Solid& solid, FaceId f)
{
    std::size_t n = 0;
    for ([[maybe_unused]] const LoopId l : solid.loops(f)) ++n;
    return n;
}

/// Of the k-th of n rings, within a circle.
Place ring_place(const Place& room, std::size_t k, std::size_t n)
{
    if (n == 1) return {room.middle, 0.5 * room.radius};
    const double angle = 0.5 * pi + 2.0 * pi * static_cast<double>(k) / static_cast<double>(n);
    const double away = 0.55 * room.radius;
    const double radius = std::min(0.3 * room.radius, 0.7 * away * std::sin(pi / static_cast<double>(n)));
    return {{room.middle.x + away * std::cos(angle), room.middle.y + away * std::sin(angle)}, radius};
}

/// Where the faces stand, one after another in rows; those with rings are larger, so that there is room inside.
std::vector<Place> face_places(std::span<const Subject> subjects)
{
    std::vector<Place> places;
    double area = 0.0;
    for (const Subject& subject : subjects)
        for (const FaceId f : subject.solid->faces()) {
            const bool has_rings = n_loops(*subject.solid, f) > 1;
            places.push_back({{}, has_rings ? with_rings : 1.0});
            area += std::pow(2.0 * places.back().radius + between, 2);
        }
    const double width = std::sqrt(columns_per_row * area);
    double x = 0.0, y = 0.0, height = 0.0;
    for (std::size_t i = 0; i < places.size();) {
        std::size_t end = i;
        for (x = 0.0, height = 0.0; end < places.size() && (end == i || x + places[end].radius < width); ++end) {
            places[end].middle.x = x + places[end].radius;
            x += 2.0 * places[end].radius + between;
            height = std::max(height, 2.0 * places[end].radius);
        }
        for (; i < end; ++i) places[i].middle.y = y - 0.5 * height;
        y -= height + between;
    }
    return places;
}

class PlaneModel {
public:
    PlaneModel(const ui::PlaneCamera& camera, double symbol_scale) : camera_(camera), symbol_scale_(symbol_scale)
    {
        shapes_.is_repeated = true;
    }

    void add(std::size_t subject, const Solid& solid, FaceId f, const Place& place)
    {
        shapes_.faces.push_back({subject, f, false});
        std::vector<LoopId> loops;
        for (const LoopId l : solid.loops(f)) loops.push_back(l);
        const int n = n_sides(solid, loops.front());
        const bool is_dot = n == 0; // a lone vertex on the rest of a sphere, whose rim is no edge
        const Polygon outline{place.middle, place.radius, is_dot ? 1 : n, false};
        std::vector<Polygon> polygons;
        if (!is_dot) polygons.push_back(outline);
        const std::size_t n_outlines = polygons.size(), n_inside = loops.size() - n_outlines;
        for (std::size_t k = 0; k < n_inside; ++k) {
            const Place ring = ring_place({place.middle, outline.inner_radius()}, k, n_inside);
            polygons.push_back({ring.middle, ring.radius, n_sides(solid, loops[k + n_outlines]), true});
        }
        fill(outline, polygons, n_outlines);
        for (std::size_t k = 0; k < loops.size(); ++k) add_loop(subject, solid, loops[k], polygons[k]);
    }
    Shapes take() { return std::move(shapes_); }

private:
    std::vector<ui::Point> rim(const Polygon& polygon) const
    {
        std::vector<ui::Point> points;
        for (int i = 0; i < polygon.n; ++i)
            for (int k = 0; k < polygon.n_points(); ++k)
                points.push_back(camera_.to_sheet(polygon.at(i, double{1.0} * k / polygon.n_points())));
        return points;
    }

    void fill(const Polygon& outer, const std::vector<Polygon>& polygons, std::size_t first_ring)
    {
        Region area{rim(outer)};
        for (std::size_t k = first_ring; k < polygons.size(); ++k)
            if (polygons[k].n > 0) area.push_back(rim(polygons[k]));
        shapes_.pieces.push_back({shapes_.faces.size() - 1, std::move(area), false});
    }

    void add_loop(std::size_t subject, const Solid& solid, LoopId l, const Polygon& polygon)
    {
        const std::size_t after = shapes_.pieces.size();
        int i = 0;
        for (const HalfEdgeId h : solid.chain(l)) {
            const ui::World2 corner = polygon.n == 0 ? polygon.middle : polygon.at(i, 0.0);
            const ui::Point at = camera_.to_sheet(corner), outward = at - camera_.to_sheet(polygon.middle);
            const ui::Point toward = ui::length(outward) > 0.0 ? ui::direction(outward) : ui::Point{};
            shapes_.vertices.push_back({subject, solid.start(h), at, false, after, toward});
            shapes_.arrows.push_back({subject, h, polygon.n == 0 ? around(corner) : arrow(polygon, i), false, after});
            if (const auto e = solid.edge(h))
                shapes_.edges.push_back({subject, *e, side(polygon, i, 1.0, 0.0), false, after, e->index});
            ++i;
        }
    }

    /// Of the polygon `factor` times as large, without `cut` of it at both ends.
    std::vector<ui::Point> side(const Polygon& polygon, int i, double factor, double cut) const
    {
        std::vector<ui::Point> line;
        const int n = polygon.n_points();
        for (int k = 0; k <= n; ++k)
            line.push_back(camera_.to_sheet(polygon.at(i, cut + (1.0 - 2.0 * cut) * k / n, factor)));
        return line;
    }

    /// Inside the face: within an outer polygon, around a ring.
    std::vector<ui::Point> arrow(const Polygon& polygon, int i) const
    {
        const double room = polygon.inner_radius() * camera_.scale();
        const double aside = std::min(beside_side * symbol_scale_, 0.35 * room) / room;
        const double factor = polygon.is_ring ? 1.0 + aside : 1.0 - aside;
        const double length = 2.0 * pi * room / std::max(1, polygon.n);
        return side(polygon, i, factor, std::min(0.2, (gap + 2.0) * symbol_scale_ / length));
    }

    std::vector<ui::Point> around(ui::World2 corner) const
    {
        constexpr double radius = 18.0; // [px]
        const ui::Point middle = camera_.to_sheet(corner);
        std::vector<ui::Point> line;
        for (int k = 0; k <= n_of_circle; ++k) {
            const double angle = pi * (0.6 + 1.7 * k / n_of_circle);
            line.push_back(middle + radius * symbol_scale_ * ui::Point{std::cos(angle), -std::sin(angle)});
        }
        return line;
    }

    const ui::PlaneCamera& camera_;
    double symbol_scale_;
    Shapes shapes_;
};

} // namespace

Shapes plane_model(std::span<const Subject> subjects, const ui::PlaneCamera& camera, const Look& look)
{
    PlaneModel model(camera, look.full_theme().symbol_scale());
    const std::vector<Place> places = face_places(subjects);
    std::size_t n = 0;
    for (std::size_t i = 0; i < subjects.size(); ++i)
        for (const FaceId f : subjects[i].solid->faces()) model.add(i, *subjects[i].solid, f, places[n++]);
    return model.take();
}

ui::PlaneCamera fitted_plane_model(std::span<const Subject> subjects, ui::Size sheet)
{
    std::vector<ui::World2> corners;
    for (const Place& place : face_places(subjects))
        for (const double d : {-place.radius, place.radius})
            corners.push_back({place.middle.x + d, place.middle.y + d});
    ui::PlaneCamera camera;
    camera.fit(corners, sheet);
    return camera;
}

} // namespace euler
