#include "topology/meshing/quad_mesher.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/topology/meshing/mesh_figures.h"

using namespace topology;
using doctest::Approx;

namespace {

CellMesh quads_of(const MeshDomain& domain, double size) { return QuadMesher(domain, {.size = size}).run(); }

std::size_t n_triangles(const CellMesh& mesh)
{
    return static_cast<std::size_t>(
        std::count_if(mesh.cells.begin(), mesh.cells.end(), [](const Cell& cell) { return cell.is_triangle(); }));
}

double worst_quality(const CellMesh& mesh)
{
    double worst = 1.0;
    for (const Cell& cell : mesh.cells) {
        std::vector<FlatPoint> corners;
        for (const CellNode node : cell.nodes()) corners.push_back(mesh.nodes[node]);
        worst = std::min(worst, QuadMesher::quality(corners));
    }
    return worst;
}

/// A circle of so many parts.
MeshDomain disc(int n)
{
    std::vector<FlatPoint> places;
    for (int i = 0; i < n; ++i)
        places.push_back({std::cos(2.0 * std::numbers::pi * i / n), std::sin(2.0 * std::numbers::pi * i / n)});
    return polygon(places);
}

} // namespace

TEST_SUITE("quadrilateral meshes")
{
    TEST_CASE("Domains with an even number of edges are quadrilaterals alone: V = Q + B/2 + 1 - h, none poor")
    {
        for (const double radius : {0.0, 0.2, 0.35}) {
            CAPTURE(radius);
            const MeshDomain domain = square_with_hole(10, radius);
            const CellMesh mesh = quads_of(domain, 0.1);
            const std::size_t n_boundary = domain.nodes.size(), n_holes = domain.loops.size() - 1;
            CHECK(n_triangles(mesh) == 0);
            CHECK(mesh.nodes.size() == mesh.cells.size() + n_boundary / 2 + 1 - n_holes);
            CHECK(area(mesh) == Approx(domain.area()).epsilon(1e-12));
            CHECK(worst_quality(mesh) > 0.4);
            check_edges(domain, mesh);
        }
    }

    TEST_CASE("Among thousands of quadrilaterals none is poor: flat ones are closed")
    {
        for (const std::size_t n_parts : {41U, 64U, 77U}) {
            CAPTURE(n_parts);
            const MeshDomain domain = square_with_hole(n_parts, 0.0);
            const CellMesh mesh = quads_of(domain, 1.0 / static_cast<double>(n_parts));
            CHECK(n_triangles(mesh) == 0);
            CHECK(area(mesh) == Approx(domain.area()).epsilon(1e-12));
            CHECK(worst_quality(mesh) > 0.3);
            check_edges(domain, mesh);
        }
    }

    TEST_CASE("An odd number of edges leaves one triangle")
    {
        for (const int n : {5, 7, 21, 33}) {
            CAPTURE(n);
            const MeshDomain domain = disc(n);
            const CellMesh mesh = quads_of(domain, 2.0 * std::numbers::pi / n);
            CHECK(n_triangles(mesh) == 1);
            CHECK(area(mesh) == Approx(domain.area()).epsilon(1e-12));
            check_edges(domain, mesh);
        }
    }

    TEST_CASE("Sharp outlines are filled by quadrilaterals alone, with one triangle where the number of edges is odd")
    {
        const auto wedge = [](double degrees) {
            return std::vector<FlatPoint>{{0, 0}, {2, 0}, {2, 2.0 * std::tan(degrees * std::numbers::pi / 180.0)}};
        };
        const std::vector<std::vector<FlatPoint>> outlines{{{0, 0}, {std::sqrt(3.0), 0}, {0, 1}},
                                                           wedge(20.0),
                                                           wedge(15.0),
                                                           wedge(10.0),
                                                           {{0, 0}, {1, -0.3}, {3, 0}, {1, 0.3}},
                                                           {{0, 0}, {2, 1}, {0, 2}, {0.6, 1}}};
        for (std::size_t i = 0; i < outlines.size(); ++i)
            for (const double size : {0.07, 0.1, 0.13, 0.2, 0.3}) {
                CAPTURE(i);
                CAPTURE(size);
                std::vector<FlatPoint> places;
                for (std::size_t k = 0; k < outlines[i].size(); ++k) {
                    const FlatPoint a = outlines[i][k], b = outlines[i][(k + 1) % outlines[i].size()];
                    const auto n = static_cast<int>(std::ceil(distance(a, b) / size - 1e-9));
                    for (int j = 0; j < n; ++j) places.push_back(a + (static_cast<double>(j) / n) * (b - a));
                }
                const MeshDomain domain = polygon(places);
                const CellMesh mesh = quads_of(domain, size);
                CHECK(n_triangles(mesh) == places.size() % 2);
                CHECK(area(mesh) == Approx(domain.area()).epsilon(1e-12));
                CHECK(worst_quality(mesh) > 0.05);
                check_edges(domain, mesh);
            }
    }

    TEST_CASE("Random stars are filled, every cell the right way round, nearly all without triangles")
    {
        std::mt19937 random(3);
        std::uniform_int_distribution<int> half(2, 25);
        std::uniform_real_distribution<double> reach(0.3, 1.0);
        int n_whole = 0;
        for (int i = 0; i < 100; ++i) {
            const int n = 2 * half(random);
            std::vector<FlatPoint> places;
            for (int k = 0; k < n; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / n, r = reach(random);
                places.push_back({r * std::cos(angle), r * std::sin(angle)});
            }
            const MeshDomain domain = polygon(places);
            const CellMesh mesh = quads_of(domain, 0.2);
            CAPTURE(i);
            CHECK(area(mesh) == Approx(domain.area()).epsilon(1e-12));
            CHECK(worst_quality(mesh) > 0.0);
            check_edges(domain, mesh);
            n_whole += n_triangles(mesh) == 0 ? 1 : 0;
        }
        CHECK(n_whole >= 98);
    }

    TEST_CASE("The nodes of the domain stay where they are, the first of the mesh, and segments are edges")
    {
        MeshDomain domain = square_with_hole(8, 0.0);
        const auto first = static_cast<CellNode>(domain.nodes.size());
        for (const FlatPoint& at : {FlatPoint{0.31, 0.43}, {0.42, 0.49}, {0.55, 0.52}}) domain.nodes.push_back(at);
        domain.segments = {{first, first + 1}, {first + 1, first + 2}};
        const CellMesh mesh = quads_of(domain, 0.125);
        CHECK(std::equal(domain.nodes.begin(), domain.nodes.end(), mesh.nodes.begin()));
        CHECK(area(mesh) == Approx(1.0).epsilon(1e-12));
        check_edges(domain, mesh);
    }

    TEST_CASE("A square has quality 1, a dart less than nothing, an equilateral triangle 1")
    {
        const FlatPoint square[] = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}},
                        dart[] = {{0.0, 0.0}, {2.0, 0.0}, {0.5, 0.5}, {0.0, 2.0}},
                        triangle[] = {{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.5 * std::numbers::sqrt3}};
        CHECK(QuadMesher::quality(square) == Approx(1.0));
        CHECK(QuadMesher::quality(dart) < 0.0);
        CHECK(QuadMesher::quality(triangle) == Approx(1.0));
    }
}
