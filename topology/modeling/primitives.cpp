#include "topology/modeling/primitives.h"

#include <cmath>
#include <numbers>

#include "topology/mesh/mesh.h"
#include "topology/modeling/construction.h"
#include "topology/modeling/lamina.h"
#include "topology/modeling/revolve.h"
#include "topology/modeling/sweep.h"

namespace topology {

namespace {

std::vector<Point> rectangle(const Point& p, const Vector& size)
{
    return {p, {p.x + size.x, p.y, p.z}, {p.x + size.x, p.y + size.y, p.z}, {p.x, p.y + size.y, p.z}};
}

} // namespace

Prism add_block(EulerOperator& op, const Point& corner, const Vector& size)
{
    const Lamina bottom = lamina(op, rectangle(corner, size));
    sweep(op, bottom.front, Vector{0.0, 0.0, size.z});
    return {bottom.back, bottom.front};
}

Prism add_prism(EulerOperator& op, int n, double radius, double height)
{
    const Lamina bottom = lamina(op, regular_polygon(n, radius));
    sweep(op, bottom.front, Vector{0.0, 0.0, height});
    return {bottom.back, bottom.front};
}

FaceId add_cone(EulerOperator& op, int n, double radius, double height)
{
    const Solid& solid = op.solid();
    const Lamina bottom = lamina(op, regular_polygon(n, radius));
    std::vector<HalfEdgeId> rim;
    for (const HalfEdgeId h : solid.chain(solid.outer(bottom.front))) rim.push_back(h);
    HalfEdgeId down = op.mev(rim.front(), {0.0, 0.0, height}).plus;
    for (std::size_t i = 1; i < rim.size(); ++i) down = op.mef(down, rim[i]).plus;
    return bottom.back;
}

void add_sphere(EulerOperator& op, double radius, int n_meridians, int n_parallels)
{
    constexpr double half_turn = std::numbers::pi / 2.0;
    std::vector<Point> meridian = arc_points({.radius = radius, .from = -half_turn, .to = half_turn}, n_parallels);
    meridian.front().x = meridian.back().x = 0.0; // the poles are on the axis, not beside it by round-off
    revolve(op, meridian, n_meridians);
}

void add_torus(EulerOperator& op, const TorusSize& size, int n_around, int n_tube)
{
    std::vector<Point> section = arc_points({.radius = size.tube, .from = 0.0, .to = -2.0 * std::numbers::pi}, n_tube);
    section.pop_back(); // the first point again
    for (Point& p : section) p.x += size.radius;
    revolve_closed(op, section, n_around);
}

FaceId sink_pocket(EulerOperator& op, FaceId face, const std::vector<Point>& outline, const Vector& by)
{
    const LoneVertex first = op.mvr(face, outline.front());
    const HalfEdgeId last = wire(op, first.half_edge, {outline.begin() + 1, outline.end()});
    const FaceId floor = op.mef(first.half_edge, last).face;
    sweep(op, floor, by);
    return floor;
}

void open_pocket(EulerOperator& op, FaceId floor, FaceId through) { op.kfmrh(through, floor); }

void add_void(EulerOperator& op, const Point& corner, const Vector& size)
{
    const Lamina bottom = lamina(op, rectangle(corner, size));
    sweep(op, bottom.back, Vector{0.0, 0.0, size.z});
}

namespace {

Point on_unit_sphere(const Point& p)
{
    const Vector direction = p - Point{};
    return Point{} + (1.0 / length(direction)) * direction;
}

Mesh icosahedron()
{
    constexpr double phi = std::numbers::phi;
    Mesh mesh;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-phi, phi})
            for (const Point& p : {Point{0.0, a, b}, Point{a, b, 0.0}, Point{b, 0.0, a}}) mesh.points.push_back(p);
    // The faces are the triples of neighbours; neighbours are 2 apart.
    const auto are_near = [&](std::uint32_t i, std::uint32_t j) {
        return length(mesh.points[i] - mesh.points[j]) < 2.1;
    };
    for (std::uint32_t i = 0; i < 12; ++i)
        for (std::uint32_t j = i + 1; j < 12; ++j)
            for (std::uint32_t k = j + 1; k < 12; ++k) {
                if (!are_near(i, j) || !are_near(j, k) || !are_near(k, i)) continue;
                const Vector a = mesh.points[i] - Point{}, b = mesh.points[j] - Point{}, c = mesh.points[k] - Point{};
                const bool is_outward = dot(cross(a, b), c) > 0.0;
                mesh.polygons.push_back(is_outward ? std::vector{i, j, k} : std::vector{i, k, j});
            }
    return mesh;
}

/// A point in the middle of each face, and a polygon about each vertex.
Mesh dual(const Solid& solid)
{
    Mesh mesh;
    for (const FaceId f : solid.faces()) {
        Vector sum{};
        double n = 0.0;
        for (const HalfEdgeId h : solid.chain(solid.outer(f))) {
            sum = sum + (solid.point(solid.start(h)) - Point{});
            n += 1.0;
        }
        mesh.points.push_back(Point{} + (1.0 / n) * sum);
    }
    for (const VertexId v : solid.vertices()) {
        std::vector<std::uint32_t> around; // a fan turns clockwise, a polygon counter-clockwise
        for (const HalfEdgeId h : solid.fan(v)) around.insert(around.begin(), solid.face(h).index);
        mesh.polygons.push_back(around);
    }
    return mesh;
}

Mesh platonic_mesh(Platonic kind)
{
    const Mesh octahedron{
        .points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        .polygons = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    switch (kind) {
    case Platonic::Tetrahedron:
        return {.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                .polygons = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
    case Platonic::Cube: return dual(solid_of(octahedron));
    case Platonic::Octahedron: return octahedron;
    case Platonic::Dodecahedron: return dual(solid_of(icosahedron()));
    case Platonic::Icosahedron: break;
    }
    return icosahedron();
}

} // namespace

Solid platonic(Platonic kind)
{
    Mesh mesh = platonic_mesh(kind);
    for (Point& p : mesh.points) p = on_unit_sphere(p);
    return construction(solid_of(mesh)).solid;
}

} // namespace topology
