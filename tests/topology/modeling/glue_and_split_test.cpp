#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/modeling/glue.h"
#include "topology/modeling/mass_properties.h"
#include "topology/modeling/primitives.h"
#include "topology/modeling/shell_and_hole.h"
#include "topology/modeling/split.h"

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

    TEST_CASE("A vertex on the plane is refused by name")
    {
        Solid solid;
        EulerOperator op(solid);
        add_block(op, {0, 0, 0}, {2, 3, 5});
        const Solid before = solid;
        CHECK_THROWS_WITH_AS(split(op, {.origin = {0, 0, 5}}), "v5 lies on the plane; move the plane a little",
                             EulerError);
        CHECK(solid == before);
    }
}
