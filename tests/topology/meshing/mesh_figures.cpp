#include "tests/topology/meshing/mesh_figures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "topology/geometry/predicates.h"

using namespace topology;

MeshDomain polygon(const std::vector<FlatPoint>& places)
{
    MeshDomain domain{.nodes = places, .loops = {{}}, .segments = {}};
    for (std::size_t i = 0; i < places.size(); ++i) domain.loops[0].push_back(static_cast<CellNode>(i));
    return domain;
}

MeshDomain square_with_hole(std::size_t n_parts, double radius)
{
    const FlatPoint corners[] = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    std::vector<FlatPoint> places;
    for (std::size_t side = 0; side < 4; ++side)
        for (std::size_t i = 0; i < n_parts; ++i)
            places.push_back(corners[side] + static_cast<double>(i) / static_cast<double>(n_parts) *
                                                 (corners[(side + 1) % 4] - corners[side]));
    MeshDomain domain = polygon(places);
    if (radius == 0.0) return domain;
    domain.loops.emplace_back();
    constexpr int n_around = 24;
    for (int i = 0; i < n_around; ++i) {
        const double angle = -2.0 * std::numbers::pi * i / n_around;
        domain.loops[1].push_back(static_cast<CellNode>(domain.nodes.size()));
        domain.nodes.push_back({0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)});
    }
    return domain;
}

MeshDomain random_star(std::mt19937& random)
{
    std::uniform_int_distribution<int> count(3, 60);
    std::uniform_real_distribution<double> reach(0.05, 1.0);
    const int n = count(random);
    std::vector<FlatPoint> places;
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n, r = reach(random);
        places.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return polygon(places);
}

double area(const CellMesh& mesh)
{
    double twice = 0.0;
    for (const Cell& cell : mesh.cells) {
        const auto nodes = cell.nodes();
        for (std::size_t i = 2; i < nodes.size(); ++i)
            twice += turn(mesh.nodes[nodes[0]], mesh.nodes[nodes[i - 1]], mesh.nodes[nodes[i]]);
    }
    return 0.5 * twice;
}

double smallest_angle(const CellMesh& mesh)
{
    double smallest = 180.0;
    for (const Cell& cell : mesh.cells) {
        const auto nodes = cell.nodes();
        const std::size_t n = nodes.size();
        for (std::size_t i = 0; i < n; ++i) {
            const FlatVector u = mesh.nodes[nodes[(i + 1) % n]] - mesh.nodes[nodes[i]],
                             v = mesh.nodes[nodes[(i + n - 1) % n]] - mesh.nodes[nodes[i]];
            smallest = std::min(smallest, std::atan2(cross(u, v), dot(u, v)) * 180.0 / std::numbers::pi);
        }
    }
    return smallest;
}

void check_edges(const MeshDomain& domain, const CellMesh& mesh)
{
    std::map<CellEdge, int> count;
    for (const Cell& cell : mesh.cells) {
        const auto nodes = cell.nodes();
        for (std::size_t i = 0; i < nodes.size(); ++i) ++count[{nodes[i], nodes[(i + 1) % nodes.size()]}];
    }
    std::map<CellEdge, int> outline;
    for (const auto& loop : domain.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) ++outline[{loop[i], loop[(i + 1) % loop.size()]}];
    bool is_each_once = true, is_matched = true;
    for (const auto& [edge, n] : count) {
        is_each_once = is_each_once && n == 1;
        is_matched = is_matched && count.contains({edge[1], edge[0]}) != outline.contains(edge);
    }
    CHECK(is_each_once);
    CHECK(is_matched);
    for (const auto& [edge, n] : outline) CHECK(count.contains(edge));
    for (const auto& [a, b] : domain.segments) CHECK(count.contains({a, b}));
}

void check_triangles(const MeshDomain& domain, const CellMesh& mesh)
{
    std::size_t n_boundary = 0;
    for (const auto& loop : domain.loops) n_boundary += loop.size();
    const std::size_t n_holes = domain.loops.size() - 1;
    CHECK(mesh.cells.size() == 2 * mesh.nodes.size() - n_boundary - 2 + 2 * n_holes);
    CHECK(area(mesh) == doctest::Approx(domain.area()).epsilon(1e-12));
    const bool has_area = std::all_of(mesh.cells.begin(), mesh.cells.end(), [&](const Cell& cell) {
        return orientation(mesh.nodes[cell.nodes()[0]], mesh.nodes[cell.nodes()[1]], mesh.nodes[cell.nodes()[2]]) > 0.0;
    });
    CHECK(has_area);
    check_edges(domain, mesh);
}
