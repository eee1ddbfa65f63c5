#include "apps/cli/bench_mesh.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <vector>

#include "topology/meshing/delaunay_mesher.h"

namespace cli {

namespace {

using topology::CellNode;
using topology::FlatPoint;
using topology::MeshDomain;

struct Hole {
    FlatPoint centre;
    double radius;
};

constexpr std::array<Hole, 5> holes{
    {{{0.5, 0.5}, 0.1}, {{0.2, 0.2}, 0.05}, {{0.8, 0.2}, 0.05}, {{0.8, 0.8}, 0.05}, {{0.2, 0.8}, 0.05}}};

void add_loop(MeshDomain& domain, const std::vector<FlatPoint>& places)
{
    std::vector<CellNode>& loop = domain.loops.emplace_back();
    for (const FlatPoint& place : places) {
        loop.push_back(static_cast<CellNode>(domain.nodes.size()));
        domain.nodes.push_back(place);
    }
}

double area_of_square_with_holes()
{
    double area = 1.0;
    for (const Hole& hole : holes) area -= std::numbers::pi * hole.radius * hole.radius;
    return area;
}

double smallest_angle(const topology::CellMesh& mesh)
{
    double largest_cosine = -1.0;
    for (const topology::Cell& cell : mesh.cells)
        for (std::size_t i = 0; i < 3; ++i) {
            const FlatPoint& at = mesh.nodes[cell.nodes()[i]];
            const topology::FlatVector u = mesh.nodes[cell.nodes()[(i + 1) % 3]] - at,
                                       v = mesh.nodes[cell.nodes()[(i + 2) % 3]] - at;
            largest_cosine = std::max(largest_cosine, dot(u, v) / (length(u) * length(v)));
        }
    return std::acos(largest_cosine) * 180.0 / std::numbers::pi;
}

} // namespace

MeshDomain square_with_five_holes(double size)
{
    MeshDomain domain;
    const auto n_side = static_cast<int>(std::max(1.0, std::round(1.0 / size)));
    std::vector<FlatPoint> square;
    constexpr std::array<FlatPoint, 5> corners{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}}};
    for (std::size_t side = 0; side < 4; ++side)
        for (int i = 0; i < n_side; ++i)
            square.push_back(corners[side] + static_cast<double>(i) / n_side * (corners[side + 1] - corners[side]));
    add_loop(domain, square);
    for (const Hole& hole : holes) {
        const double around = 2.0 * std::numbers::pi;
        const auto n = static_cast<int>(std::max(8.0, std::round(around * hole.radius / size)));
        std::vector<FlatPoint> circle;
        for (int i = 0; i < n; ++i)
            circle.push_back(hole.centre +
                             hole.radius * topology::FlatVector{std::cos(around * i / n), -std::sin(around * i / n)});
        add_loop(domain, circle);
    }
    return domain;
}

double edge_length_of(std::size_t n_triangles)
{
    return std::sqrt(4.0 * area_of_square_with_holes() / (std::numbers::sqrt3 * static_cast<double>(n_triangles)));
}

MeshBench bench_mesh(std::size_t n_triangles)
{
    const double size = edge_length_of(n_triangles);
    const MeshDomain domain = square_with_five_holes(size);
    const auto begin = std::chrono::steady_clock::now();
    const topology::CellMesh mesh = topology::DelaunayMesher(domain, {.size = size}).run();
    return {.triangles = mesh.cells.size(),
            .vertices = mesh.nodes.size(),
            .min_angle = smallest_angle(mesh),
            .seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
}

} // namespace cli
