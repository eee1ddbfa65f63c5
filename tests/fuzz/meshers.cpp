// Whatever the outline, every mesher fills it or says that its edges cross: nodes and edges of the outline stay, all cells
// have area and run counter-clockwise, areas sum up, and Euler's relation holds.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string_view>

#include "tests/fuzz/bytes.h"
#include "topology/geometry/predicates.h"
#include "topology/meshing/delaunay_mesher.h"
#include "topology/meshing/front_mesher.h"
#include "topology/meshing/quad_mesher.h"
#include "topology/meshing/quadtree_mesher.h"

namespace {

using namespace topology;
using fuzz::Bytes;
using fuzz::place;

constexpr double smallest_size =
    0.04; // over the width of the box that outlines are in: some thousands of cells at most

/// Counter-clockwise around what is inside, or clockwise.
void add_loop(MeshDomain& domain, const std::vector<FlatPoint>& places, bool is_around)
{
    std::vector<CellNode> loop;
    double twice = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        loop.push_back(static_cast<CellNode>(domain.nodes.size()));
        domain.nodes.push_back(places[i]);
        twice += turn(places[0], places[i], places[(i + 1) % places.size()]);
    }
    if ((twice > 0.0) != is_around) std::reverse(loop.begin(), loop.end());
    domain.loops.push_back(std::move(loop));
}

std::vector<FlatPoint> places(Bytes& bytes, std::size_t n)
{
    std::vector<FlatPoint> all;
    for (std::size_t i = 0; i < n; ++i) all.push_back(place(bytes));
    return all;
}

/// A star, that never crosses itself but for the sharpest of corners.
std::vector<FlatPoint> star(Bytes& bytes, std::size_t n)
{
    std::vector<FlatPoint> all;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2.0 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(n);
        const double reach = (1.0 + bytes.next()) / 512.0;
        all.push_back({0.5 + reach * std::cos(angle), 0.5 + reach * std::sin(angle)});
    }
    return all;
}

MeshDomain domain_of(Bytes& bytes)
{
    MeshDomain domain;
    const std::uint8_t kind = bytes.next();
    const std::size_t n = 3 + bytes.next() % 30;
    add_loop(domain, kind % 2 == 0 ? star(bytes, n) : places(bytes, n), true);
    if (kind & 2U) add_loop(domain, places(bytes, 3 + bytes.next() % 5), false);
    if (kind & 4U) {
        const auto first = static_cast<CellNode>(domain.nodes.size());
        for (const FlatPoint& at : places(bytes, 2)) domain.nodes.push_back(at);
        domain.segments.push_back({first, first + 1});
    }
    if (kind & 8U) domain.nodes.push_back(place(bytes));
    return domain;
}

[[noreturn]] void fail(std::string_view mesher, std::string_view what)
{
    std::cerr << mesher << ": " << what << '\n';
    std::abort();
}

bool has_area(const CellMesh& mesh, const Cell& cell)
{
    const auto nodes = cell.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const FlatPoint &a = mesh.nodes[nodes[i]], &b = mesh.nodes[nodes[(i + 1) % nodes.size()]],
                        &c = mesh.nodes[nodes[(i + 2) % nodes.size()]];
        if (!(orientation(a, b, c) > 0.0)) return false;
    }
    return true;
}

double area_of(const CellMesh& mesh)
{
    double twice = 0.0;
    for (const Cell& cell : mesh.cells)
        for (std::size_t i = 2; i < cell.nodes().size(); ++i)
            twice += turn(mesh.nodes[cell.nodes()[0]], mesh.nodes[cell.nodes()[i - 1]], mesh.nodes[cell.nodes()[i]]);
    return 0.5 * twice;
}

void require_edges(const MeshDomain& domain, const CellMesh& mesh, std::string_view mesher)
{
    std::set<CellEdge> edges, outline;
    for (const auto& loop : domain.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) outline.insert({loop[i], loop[(i + 1) % loop.size()]});
    for (const Cell& cell : mesh.cells)
        for (std::size_t i = 0; i < cell.nodes().size(); ++i)
            if (!edges.insert({cell.nodes()[i], cell.nodes()[(i + 1) % cell.nodes().size()]}).second)
                fail(mesher, "two cells have one edge to their left");
    for (const CellEdge& edge : edges)
        if (edges.contains({edge[1], edge[0]}) == outline.contains(edge)) fail(mesher, "an edge has no other side");
    for (const CellEdge& edge : outline)
        if (!edges.contains(edge)) fail(mesher, "an edge of the outline is missing");
}

/// 2 V = 2 - 2 h + T + 2 Q + B, of nodes that are used.
void require_relation(const MeshDomain& domain, const CellMesh& mesh, std::string_view mesher)
{
    std::set<CellNode> used;
    std::size_t n_triangles = 0, n_boundary = 0;
    for (const Cell& cell : mesh.cells) {
        used.insert(cell.nodes().begin(), cell.nodes().end());
        n_triangles += cell.is_triangle() ? 1U : 0U;
    }
    for (const auto& loop : domain.loops) n_boundary += loop.size();
    const std::size_t n_quads = mesh.cells.size() - n_triangles, n_holes = domain.loops.size() - 1;
    if (2 * used.size() + 2 * n_holes != 2 + n_triangles + 2 * n_quads + n_boundary)
        fail(mesher, "Euler's relation does not hold");
}

/// Whether the outline could be meshed.
template <class AnyMesher> bool mesh_with(const MeshDomain& domain, double size, std::string_view name)
{
    CellMesh mesh;
    try {
        mesh = AnyMesher(domain, {.size = size, .sizes = {}}).run();
    } catch (const CrossingEdges&) {
        return false;
    }
    if (!std::equal(domain.nodes.begin(), domain.nodes.end(), mesh.nodes.begin())) fail(name, "a node has moved");
    for (const Cell& cell : mesh.cells)
        if (!has_area(mesh, cell)) fail(name, "a cell is turned inside out");
    require_edges(domain, mesh, name);
    require_relation(domain, mesh, name);
    if (!(std::abs(area_of(mesh) - domain.area()) < 1e-9)) fail(name, "areas do not sum up");
    return true;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Bytes bytes(data, size);
    const double edge = smallest_size * (1.0 + bytes.next() / 16.0);
    const MeshDomain domain = domain_of(bytes);
    const bool is_sound = mesh_with<DelaunayMesher>(domain, edge, "delaunay");
    if (mesh_with<FrontMesher>(domain, edge, "front") != is_sound) fail("front", "refused what Delaunay does not");
    if (mesh_with<QuadtreeMesher>(domain, edge, "quadtree") != is_sound)
        fail("quadtree", "refused what Delaunay does not");
    if (mesh_with<QuadMesher>(domain, edge, "quads") != is_sound) fail("quads", "refused what Delaunay does not");
    return 0;
}
