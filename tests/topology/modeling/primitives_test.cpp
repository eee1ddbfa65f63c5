#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/modeling/lamina.h"
#include "topology/modeling/mass_properties.h"
#include "topology/modeling/primitives.h"
#include "topology/modeling/revolve.h"

using namespace topology;

namespace {

constexpr double pi = std::numbers::pi;

Solid made(const std::function<void(EulerOperator&)>& make)
{
    Solid solid;
    EulerOperator op(solid);
    make(op);
    validate(solid);
    return solid;
}

/// Area of a regular n-gon on a circle.
double polygon_area(int n, double radius) { return 0.5 * n * radius * radius * std::sin(2.0 * pi / n); }

} // namespace

TEST_SUITE("primitives")
{
    TEST_CASE("A block has its edges' product for volume, and its middle for centroid")
    {
        const Solid solid = made([](EulerOperator& op) { add_block(op, {1, -2, 3}, {2, 3, 5}); });
        CHECK(euler_counts(solid) == EulerCounts{.V = 8, .E = 12, .F = 6, .L = 6, .S = 1, .G = 0});
        const MassProperties mass = mass_properties(solid);
        CHECK(mass.volume == doctest::Approx(30.0));
        CHECK(mass.area == doctest::Approx(2.0 * (6 + 15 + 10)));
        CHECK(mass.centroid.x == doctest::Approx(2.0));
        CHECK(mass.centroid.y == doctest::Approx(-0.5));
        CHECK(mass.centroid.z == doctest::Approx(5.5));
    }

    TEST_CASE("A prism's volume is base times height, a cone's a third, its centroid at a quarter of the height")
    {
        const MassProperties prism = mass_properties(made([](EulerOperator& op) { add_prism(op, 7, 1.5, 4.0); }));
        CHECK(prism.volume == doctest::Approx(4.0 * polygon_area(7, 1.5)));
        const Solid cone = made([](EulerOperator& op) { add_cone(op, 5, 1.5, 4.0); });
        CHECK(euler_counts(cone) == EulerCounts{.V = 6, .E = 10, .F = 6, .L = 6, .S = 1, .G = 0});
        CHECK(mass_properties(cone).volume == doctest::Approx(4.0 / 3.0 * polygon_area(5, 1.5)));
        CHECK(mass_properties(cone).centroid.z == doctest::Approx(1.0));
    }

    TEST_CASE("A torus's volume is its section times the way of the section's middle, "
              "as Pappus has it for a polygon of turns")
    {
        // Between two steps the section moves by a chord, so that n sin(2 pi / n) / (2 pi) of Pappus's volume is there.
        constexpr int n_around = 24, n_tube = 9;
        const Solid solid = made(
            [](EulerOperator& op) { add_torus(op, {.radius = 3.0, .tube = 0.8}, n_around, n_tube); });
        const std::size_t n = 24 * 9;
        CHECK(euler_counts(solid) == EulerCounts{.V = n, .E = 2 * n, .F = n, .L = n, .S = 1, .G = 1});
        const double pappus = polygon_area(n_tube, 0.8) * 2.0 * pi * 3.0;
        const double exact = pappus * std::sin(2.0 * pi / n_around) / (2.0 * pi / n_around);
        CHECK(mass_properties(solid).volume == doctest::Approx(exact));
        CHECK(mass_properties(solid).volume == doctest::Approx(pappus).epsilon(0.02));
    }

    TEST_CASE("The book's torus: a square in six steps is V 24, E 48, F 24, L 24, S 1, G 1")
    {
        const Solid solid = made([](EulerOperator& op) { add_torus(op, {.radius = 2.0, .tube = 0.5}, 6, 4); });
        CHECK(euler_counts(solid) == EulerCounts{.V = 24, .E = 48, .F = 24, .L = 24, .S = 1, .G = 1});
    }

    TEST_CASE("A revolved profile's volume is its area times the way of its centroid: Pappus")
    {
        // A triangle with the axis: base 2, height 3, centroid at x = 2/3.
        constexpr int n = 40;
        const Solid solid = made([](EulerOperator& op) { revolve(op, {{0, 0, 0}, {2, 0, 1}, {0, 0, 3}}, n); });
        const double pappus = 0.5 * 2.0 * 3.0 * 2.0 * pi * (2.0 / 3.0);
        const double exact = pappus * std::sin(2.0 * pi / n) / (2.0 * pi / n);
        CHECK(mass_properties(solid).volume == doctest::Approx(exact));
        CHECK(euler_counts(solid) == EulerCounts{.V = 42, .E = 120, .F = 80, .L = 80, .S = 1, .G = 0});
    }

    TEST_CASE("A fine sphere has nearly the volume and the area of a ball")
    {
        const Solid solid = made([](EulerOperator& op) { add_sphere(op, 2.0, 96, 48); });
        CHECK(euler_counts(solid).V == 2 + 96 * 47);
        CHECK(mass_properties(solid).volume == doctest::Approx(4.0 / 3.0 * pi * 8.0).epsilon(0.005));
        CHECK(mass_properties(solid).area == doctest::Approx(4.0 * pi * 4.0).epsilon(0.005));
    }

    TEST_CASE("A through hole takes its volume away and makes a handle; a void takes it and makes a shell")
    {
        const Solid hole = made([](EulerOperator& op) {
            const Prism block = add_block(op, {0, 0, 0}, {4, 5, 2});
            open_pocket(op, sink_pocket(op, block.top, {{1, 1, 2}, {3, 1, 2}, {3, 2, 2}, {1, 2, 2}}, {0, 0, -2}),
                        block.base);
        });
        CHECK(euler_counts(hole) == EulerCounts{.V = 16, .E = 24, .F = 10, .L = 12, .S = 1, .G = 1});
        CHECK(mass_properties(hole).volume == doctest::Approx(40.0 - 4.0));
        CHECK(mass_properties(hole).area == doctest::Approx(2.0 * (20 + 8 + 10) - 4.0 + 12.0));
        const Solid hollow = made([](EulerOperator& op) {
            add_block(op, {0, 0, 0}, {4, 5, 3});
            add_void(op, {1, 1, 1}, {2, 1, 1});
        });
        CHECK(euler_counts(hollow).S == 2);
        CHECK(mass_properties(hollow).volume == doctest::Approx(60.0 - 2.0));
    }

    TEST_CASE("The Platonic solids have their counts and their volumes")
    {
        const double s5 = std::sqrt(5.0), R = 1.0;
        struct Known {
            Platonic kind;
            EulerCounts counts;
            double volume; // by the radius of the corners
        };
        const double dodecahedron_edge = 4.0 * R / (std::sqrt(3.0) * (1.0 + s5));
        const double icosahedron_edge = 4.0 * R / std::sqrt(10.0 + 2.0 * s5);
        for (const Known& known :
             {Known{Platonic::Tetrahedron, {4, 6, 4, 4, 1, 0}, 8.0 * std::sqrt(3.0) / 27.0},
              Known{Platonic::Cube, {8, 12, 6, 6, 1, 0}, 8.0 / (3.0 * std::sqrt(3.0))},
              Known{Platonic::Octahedron, {6, 12, 8, 8, 1, 0}, 4.0 / 3.0},
              Known{Platonic::Dodecahedron, {20, 30, 12, 12, 1, 0}, (15 + 7 * s5) / 4 * std::pow(dodecahedron_edge, 3)},
              Known{
                  Platonic::Icosahedron, {12, 30, 20, 20, 1, 0}, 5 * (3 + s5) / 12 * std::pow(icosahedron_edge, 3)}}) {
            const Solid solid = platonic(known.kind);
            validate(solid);
            CHECK(euler_counts(solid) == known.counts);
            CHECK(mass_properties(solid).volume == doctest::Approx(known.volume));
            for (const VertexId v : solid.vertices()) CHECK(length(solid.point(v) - Point{}) == doctest::Approx(1.0));
        }
    }
}
