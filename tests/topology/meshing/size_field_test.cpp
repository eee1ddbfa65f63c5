#include "topology/meshing/size_field.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>

#include "tests/topology/meshing/mesh_figures.h"
#include "topology/meshing/delaunay_mesher.h"
#include "topology/meshing/front_mesher.h"
#include "topology/meshing/quad_mesher.h"
#include "topology/meshing/quadtree_mesher.h"

using namespace topology;
using doctest::Approx;

namespace {

/// Small elements are wanted at one place.
std::shared_ptr<const SizeField> field_about(const FlatPoint& at, double size, double growth)
{
    return std::make_shared<const SizeField>(std::vector<SizeField::Sample>{{at, size}}, growth);
}

} // namespace

TEST_SUITE("fields of sizes")
{
    TEST_CASE("A field of sizes is the least over all its samples of their size plus the growth by their distance")
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> place(-3.0, 5.0), size(0.01, 0.4);
        std::vector<SizeField::Sample> samples;
        for (int i = 0; i < 300; ++i) samples.push_back({{place(random), 0.3 * place(random)}, size(random)});
        const SizeField field(samples, 0.23);
        for (int i = 0; i < 200; ++i) {
            const FlatPoint at{place(random), place(random)};
            double least = 1e9;
            for (const auto& sample : samples) least = std::min(least, sample.size + 0.23 * distance(at, sample.at));
            CHECK(field.at(at) == least);
        }
        CHECK(field.least() == std::ranges::min_element(samples, {}, &SizeField::Sample::size)->size);
        CHECK(std::isinf(SizeField().at({1.0, 2.0})));
    }

    TEST_CASE("Every mesher of free outlines makes its cells as small as a field of sizes wants them inside")
    {
        const MeshDomain domain = square_with_hole(5, 0.0); // edges of 0.2
        const FlatPoint middle_of_it{0.52, 0.47};
        const MesherOptions options{.size = 0.2, .field = field_about(middle_of_it, 0.01, 0.3)};
        const CellMesh meshes[] = {DelaunayMesher(domain, options).run(), FrontMesher(domain, options).run(),
                                   QuadtreeMesher(domain, options).run(), QuadMesher(domain, options).run()};
        for (const CellMesh& mesh : meshes) {
            CAPTURE(&mesh - meshes);
            CHECK(area(mesh) == Approx(1.0).epsilon(1e-12));
            for (const Cell& cell : mesh.cells)
                for (std::size_t i = 0; i < cell.nodes().size(); ++i) {
                    const FlatPoint &a = mesh.nodes[cell.nodes()[i]],
                                    &b = mesh.nodes[cell.nodes()[(i + 1) % cell.nodes().size()]];
                    CHECK(distance(a, b) < 2.2 * options.limited(1.0, middle(a, b)) + 0.02);
                }
            // equilateral triangles of these sizes: the integral of 2 pi r dr / (sqrt(3)/4 h^2) to where h is 0.2
            const double n = 8.0 * std::numbers::pi / std::numbers::sqrt3 / (0.3 * 0.3) *
                             (std::log(0.2 / 0.01) + 0.01 / 0.2 - 1.0);
            const double share = mesh.cells.front().is_triangle() ? 1.0 : 0.5; // two make a quadrilateral
            CHECK(static_cast<double>(mesh.cells.size()) > share * n);
            CHECK(static_cast<double>(mesh.cells.size()) < 4.0 * share * n);
        }
    }
}
