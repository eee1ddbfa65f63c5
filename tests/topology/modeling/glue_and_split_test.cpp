#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/modeling/glue.h"
#include "topology/modeling/lamina.h"
#include "topology/modeling/mass_properties.h"
#include "topology/modeling/primitives.h"
#include "topology/modeling/shell_and_hole.h"
#include "topology/modeling/split.h"
#include "topology/modeling/sweep.h"

using namespace topology;

TEST_SUITE("glue")
{
    TEST_CASE("Two stacked blocks become one of twelve corners, and nothing of their volume is lost")
    {
        Solid solid;
        EulerOperator op(solid);
        const Prism lower = add_block(op, {0, 0, 0}, {2, 3, 1}), upper = add_block(op, {0, 0, 1}, {2, 3, 4});
        CHECK(op.solid().counts().faces == 12);
        glue(op, lower.top, upper.base);
        validate(solid);
        CHECK(euler_counts(solid) == EulerCounts{.V = 12, .E = 20, .F = 10, .L = 10, .S = 1, .G = 0});
        CHECK(mass_properties(solid).volume == doctest::Approx(30.0));
        for (const FaceId f : solid.faces()) {
            int n = 0;
            for ([[maybe_unused]] const HalfEdgeId h : solid.chain(solid.outer(f))) ++n;
            CHECK(n == 4);
        }
    }

    TEST_CASE("Faces that do not lie upon one another are refused, and nothing changes")
    {
        Solid solid;
        EulerOperator op(solid);
        const Prism lower = add_block(op, {0, 0, 0}, {2, 3, 1}), upper = add_block(op, {0, 0, 1.5}, {2, 3, 4});
        const Solid before = solid;
        CHECK_THROWS_AS(glue(op, lower.top, upper.base), EulerError);
        CHECK(why_not_glue(op, lower.top, lower.base)->kind == RefusalKind::NotFaceToFace);
        CHECK(why_not_glue(op, lower.top, lower.top)->kind == RefusalKind::SameFace);
        CHECK(solid == before);
        glue(op, lower.top, upper.base, 0.6);
        validate(solid);
    }

    TEST_CASE("MSG adds a shell and a handle at once, KSG takes both away")
    {
        Solid solid;
        EulerOperator op(solid);
        const Prism block = add_block(op, {0, 0, 0}, {9, 9, 1}), boss = add_block(op, {3, 3, 1}, {1, 1, 1});
        const LoopId foot = solid.outer(boss.base), lid = solid.outer(boss.top);
        op.kfmrh(block.top, boss.base);
        const EulerCounts before = euler_counts(solid);
        const Solid joined = solid;
        const FaceId base = make_shell_and_hole(op, {.ring = foot, .host = block.base, .face = block.top});
        validate(solid);
        CHECK(euler_counts(solid).S == before.S + 1);
        CHECK(euler_counts(solid).G == before.G + 1);
        CHECK(euler_counts(solid).F == before.F);
        CHECK(solid.has(base));
        LoopId handle = foot;
        for (const LoopId l : solid.loops(block.base))
            if (!solid.is_outer(l)) handle = l;
        CHECK_THROWS_AS(make_shell_and_hole(op, {.ring = handle, .host = block.base, .face = boss.top}), EulerError);
        kill_shell_and_hole(op, {.ring = handle, .host = block.base, .face = base});
        validate(solid);
        CHECK(euler_counts(solid) == before);
        CHECK(solid.outer(boss.top) == lid);
        CHECK(euler_counts(joined) == before);
    }
}

namespace {

/// Every part lies on its side of the plane, and together they are the whole.
void check_split(Solid solid, const Plane& plane)
{
    const double whole = mass_properties(solid).volume;
    EulerOperator op(solid);
    const Split made = split(op, plane);
    const auto breach = why_not_valid(solid);
    REQUIRE_MESSAGE(!breach, (breach ? sentence(*breach) : ""));
    CHECK(euler_counts(solid).formula() == 0);
    double sum = 0.0;
    for (const Shell& shell : shells(solid)) {
        double least = 0.0, greatest = 0.0;
        for (const FaceId f : shell.faces)
            for (const LoopId l : solid.loops(f))
                for (const HalfEdgeId h : solid.chain(l)) {
                    least = std::min(least, plane.height(solid.point(solid.start(h))));
                    greatest = std::max(greatest, plane.height(solid.point(solid.start(h))));
                }
        CHECK(std::min(-least, greatest) < 1e-9);
        sum += mass_properties(solid, shell.faces).volume;
    }
    CHECK(sum == doctest::Approx(whole));
    double above = 0.0, below = 0.0;
    for (const FaceId f : made.above) above += dot(area_vector(solid, f), plane.normal);
    for (const FaceId f : made.below) below += dot(area_vector(solid, f), plane.normal);
    CHECK(above == doctest::Approx(-below));
    CHECK(above <= 0.0);
}

Solid block_with_hole()
{
    Solid solid;
    EulerOperator op(solid);
    const Prism block = add_block(op, {0, 0, 0}, {4, 5, 2});
    open_pocket(op, sink_pocket(op, block.top, {{1, 1, 2}, {3, 1, 2}, {3, 2, 2}, {1, 2, 2}}, {0, 0, -2}), block.base);
    add_void(op, {1, 3, 0.5}, {2, 1, 1});
    return solid;
}

} // namespace

TEST_SUITE("split")
{
    TEST_CASE("A block cut across falls into two of the volumes that the plane says")
    {
        Solid solid;
        EulerOperator op(solid);
        add_block(op, {0, 0, 0}, {2, 3, 5});
        const Split made = split(op, {.origin = {0, 0, 1.25}});
        validate(solid);
        CHECK(euler_counts(solid) == EulerCounts{.V = 16, .E = 24, .F = 12, .L = 12, .S = 2, .G = 0});
        REQUIRE(made.above.size() == 1);
        CHECK(area_vector(solid, made.above.front()).z == doctest::Approx(-6.0));
        double least = 30.0;
        for (const Shell& shell : shells(solid)) least = std::min(least, mass_properties(solid, shell.faces).volume);
        CHECK(least == doctest::Approx(7.5));
    }

    TEST_CASE("A plane across a through hole leaves it in both parts; one along it opens it")
    {
        Solid across = block_with_hole(), along = block_with_hole();
        EulerOperator op_across(across), op_along(along);
        split(op_across, {.origin = {0, 0, 1.2}});
        CHECK(euler_counts(across).S == 2); // the void is cut too, and opens into the plane
        CHECK(euler_counts(across).G == 2);
        split(op_along, {.origin = {0, 1.5, 0}, .normal = {0, 1, 0}});
        CHECK(euler_counts(along).G == 0);
        CHECK(euler_counts(along).S == 3); // one part still holds the void
        check_split(block_with_hole(), {.origin = {0, 0, 1.2}});
        check_split(block_with_hole(), {.origin = {0, 1.5, 0}, .normal = {0, 1, 0}});
        check_split(block_with_hole(), {.origin = {0, 2.5, 0}, .normal = {0, 1, 0}});
        check_split(block_with_hole(), {.origin = {0, 2.5, 9}});
    }

    TEST_CASE("Any plane cuts blocks with holes and voids, tori and spheres into parts that add up to the whole")
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        Solid torus, sphere;
        EulerOperator on_torus(torus), on_sphere(sphere);
        add_torus(on_torus, {.radius = 2.0, .tube = 0.7}, 11, 7);
        add_sphere(on_sphere, 1.5, 9, 6);
        for (int i = 0; i < 150; ++i) {
            CAPTURE(i);
            const Vector normal{any(random), any(random), any(random)};
            check_split(block_with_hole(),
                        {.origin = {2 + 1.5 * any(random), 2.5 + 2 * any(random), 1 + any(random)}, .normal = normal});
            check_split(torus, {.origin = {any(random), any(random), 0.3 * any(random)}, .normal = normal});
            check_split(sphere, {.origin = {any(random), any(random), any(random)}, .normal = normal});
        }
    }

    TEST_CASE("A cube is cut along its diagonal plane into two prisms, across a corner into a tetrahedron and the rest")
    {
        Solid halves, corner;
        EulerOperator on_halves(halves), on_corner(corner);
        add_block(on_halves, {0, 0, 0}, {2, 2, 2});
        split(on_halves, {.origin = {0, 0, 7}, .normal = {1, -1, 0}});
        validate(halves);
        CHECK(euler_counts(halves) == EulerCounts{.V = 12, .E = 18, .F = 10, .L = 10, .S = 2, .G = 0});
        for (const Shell& shell : shells(halves))
            CHECK(mass_properties(halves, shell.faces).volume == doctest::Approx(4.0));
        add_block(on_corner, {0, 0, 0}, {2, 2, 2});
        split(on_corner, {.origin = {2, 0, 0}, .normal = {1, 1, 1}});
        validate(corner);
        CHECK(euler_counts(corner) == EulerCounts{.V = 4 + 7, .E = 6 + 12, .F = 4 + 7, .L = 4 + 7, .S = 2, .G = 0});
        CHECK(mass_properties(corner, shells(corner).back().faces).volume +
                  mass_properties(corner, shells(corner).front().faces).volume ==
              doctest::Approx(8.0));
    }

    TEST_CASE("A plane that only touches a solid, at a vertex or a face, changes nothing")
    {
        Solid solid;
        EulerOperator op(solid);
        add_block(op, {0, 0, 0}, {2, 3, 5});
        const Solid before = solid;
        for (const Plane& plane :
             {Plane{{0, 0, 5}}, Plane{{0, 0, 0}}, Plane{{0, 0, 5}, {0, 0, -1}}, Plane{{2, 3, 5}, {1, 1, 1}},
              Plane{{2, 3, 5}, {-1, -1, -1}}, Plane{{2, 3, 0}, {1, 1, 0}}, Plane{{2, 3, 0}, {-1, -1, 0}}}) {
            const Split made = split(op, plane);
            CHECK(made.above.empty());
            CHECK(made.below.empty());
            CHECK(solid == before);
        }
    }

    TEST_CASE("At the height of a step the part that stands on it is cut off")
    {
        for (const double turned : {1.0, -1.0}) {
            Solid solid;
            EulerOperator op(solid);
            const Lamina profile = lamina(op, {{0, 0, 0}, {0, 0, 2}, {1, 0, 2}, {1, 0, 1}, {2, 0, 1}, {2, 0, 0}});
            sweep(op, profile.front, {0, 3, 0});
            REQUIRE(mass_properties(solid).volume == doctest::Approx(9.0));
            const Split made = split(op, {.origin = {0, 0, 1}, .normal = {0, 0, turned}});
            validate(solid);
            CHECK(shells(solid).size() == 2);
            for (const Shell& shell : shells(solid)) {
                const double volume = mass_properties(solid, shell.faces).volume;
                CHECK((std::abs(volume - 3.0) < 1e-12 || std::abs(volume - 6.0) < 1e-12));
            }
            REQUIRE(made.above.size() == 1);
            CHECK(area_vector(solid, made.above.front()).z == doctest::Approx(-3.0 * turned));
        }
    }

    TEST_CASE("Planes through any three vertices cut blocks with holes and voids, tori and spheres soundly")
    {
        std::mt19937 random(7);
        Solid torus, sphere;
        EulerOperator on_torus(torus), on_sphere(sphere);
        add_torus(on_torus, {.radius = 2.0, .tube = 0.7}, 11, 7);
        add_sphere(on_sphere, 1.5, 8, 6);
        for (const Solid& solid : {block_with_hole(), torus, sphere}) {
            const auto any_vertex = [&] {
                std::uniform_int_distribution<std::uint32_t> any(
                    0, static_cast<std::uint32_t>(solid.vertices().n_rows()) - 1);
                VertexId v{any(random)};
                while (!solid.has(v)) v = VertexId{any(random)};
                return solid.point(v);
            };
            for (int i = 0; i < 200; ++i) {
                CAPTURE(i);
                const Point p = any_vertex();
                const Plane plane{.origin = p, .normal = cross(any_vertex() - p, any_vertex() - p)};
                Solid copy = solid;
                const EulerOperator op(copy);
                if (length(plane.normal) > 1e-9 && !why_not_split(op, plane)) check_split(solid, plane);
            }
        }
    }

    TEST_CASE("A vertex whose faces in the plane bound parts on both sides is refused by its name")
    {
        Solid solid;
        EulerOperator op(solid);
        lamina(op, {{0, 0, 1}, {3, 0, 1}, {0, 2, 1}});
        const Solid before = solid;
        CHECK_THROWS_WITH_AS(
            split(op, {.origin = {0, 0, 1}}),
            "at v2 faces in the plane meet whose parts lie on both sides of it; move the plane a little", EulerError);
        CHECK(solid == before);
        CHECK(!why_not_split(op, {.origin = {0, 0, 2}}));
    }
}
