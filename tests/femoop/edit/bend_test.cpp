// A member that is bent into an arc or a parabola: where its parts lie, and that they bear what the member bore.
#include "femoop/edit/bend.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "femoop/analysis/linear_static.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/model/check/check.h"
#include "femoop/model/fault/errors_among.h"
#include "tests/femoop/analysis/random_structure.h"

using namespace femoop;

namespace {

constexpr double span = 20.0, rise = 5.0, intensity = 12.0; // m, kN/m

/// Two pinned ends and one member that bears q downwards, per unit of its length or of its projection.
Model beam(bool projected)
{
    Model model;
    model.add(Material{.id = "m", .E = 1e8});
    model.add(Section{.id = "s", .A = 1e-1, .Iz = 1e-3});
    for (const double x : {0.0, span}) model.add(Node{.id = x == 0.0 ? "A" : "B", .at = {x, 0.0, 0.0}});
    for (Node& node : model.nodes) node.support = Support{.fixed = {Dof::ux, Dof::uy}};
    model.add(Member{.id = "AB", .nodes = {NodeId(0), NodeId(1)}, .material = MaterialId(0), .section = SectionId(0)});
    DistributedLoad load{.values = {{Dof::uy, -intensity, std::nullopt}}};
    load.projected = projected;
    model.load_cases.push_back({.id = "G"});
    model.load_cases.front().members.push_back({MemberId(0), load});
    return model;
}

double reaction(const Model& model, NodeId node, Dof dof)
{
    return analyse(model)[CaseId(0)].reaction(node)[index(dof)];
}

} // namespace

TEST_SUITE_BEGIN("bending of members");

TEST_CASE("A parabola's nodes lie on 4 f x (L - x) / L^2 at equal distances along the chord")
{
    Model model = beam(true);
    const BentMember bent = bend_member(model, MemberId(0), {BendCurve::Parabola, rise, 8});
    REQUIRE(bent.nodes.size() == 7);
    REQUIRE(bent.members.size() == 8);
    for (std::size_t i = 0; i < bent.nodes.size(); ++i) {
        const double x = span * static_cast<double>(i + 1) / 8.0;
        CHECK(model[bent.nodes[i]].at[0] == doctest::Approx(x));
        CHECK(model[bent.nodes[i]].at[1] == doctest::Approx(4.0 * rise * x * (span - x) / (span * span)));
    }
}

TEST_CASE("An arc's nodes are as far from its centre as its ends, with parts of one length")
{
    for (const double f : {1.0, 5.0, 10.0, 14.0, -3.0}) {
        CAPTURE(f);
        Model model = beam(false);
        const BentMember bent = bend_member(model, MemberId(0), {BendCurve::Arc, f, 6});
        const double radius = (span * span / 4.0 + f * f) / (2.0 * f), centre = f - radius;
        for (const NodeId node : bent.nodes) {
            const double x = model[node].at[0] - 0.5 * span, y = model[node].at[1] - centre;
            CHECK(std::hypot(x, y) == doctest::Approx(std::abs(radius)));
        }
        CHECK(model[bent.nodes[2]].at[1] == doctest::Approx(f));
        for (const MemberId member : bent.members)
            CHECK(geometry_of(model, model[member]).length ==
                  doctest::Approx(geometry_of(model, model[bent.members.front()]).length));
    }
}

// Two-hinged arches that deform little along their axis: the thrust of a parabola under a load of its projection is
// that of its line of thrust, q L^2 / 8 f, whatever its stiffness against bending.
TEST_CASE("A parabola under a projected load is its own line of thrust: H = q L^2 / 8 f")
{
    Model model = beam(true);
    bend_member(model, MemberId(0), {BendCurve::Parabola, rise, 64});
    CHECK(check(model).empty());
    CHECK(reaction(model, NodeId(0), Dof::uy) == doctest::Approx(intensity * span / 2.0));
    CHECK(reaction(model, NodeId(0), Dof::ux) == doctest::Approx(intensity * span * span / (8.0 * rise)).epsilon(0.01));
}

TEST_CASE("A load per unit of length grows with the length of the half circle")
{
    Model model = beam(false);
    bend_member(model, MemberId(0), {BendCurve::Arc, 0.5 * span, 90});
    CHECK(reaction(model, NodeId(0), Dof::uy) ==
          doctest::Approx(intensity * std::numbers::pi * span / 4.0).epsilon(1e-3)); // half of q pi R
}

TEST_CASE("What is bent the other way is the mirror image")
{
    Model up = beam(false), down = beam(false);
    bend_member(up, MemberId(0), {BendCurve::Arc, 3.0, 5});
    bend_member(down, MemberId(0), {BendCurve::Arc, -3.0, 5});
    for (std::size_t i = 0; i < up.nodes.size(); ++i) {
        CHECK(up.nodes[i].at[0] == doctest::Approx(down.nodes[i].at[0]));
        CHECK(up.nodes[i].at[1] == doctest::Approx(-down.nodes[i].at[1]));
    }
}

TEST_CASE("Any member of a random structure can be bent, and the model stays sound")
{
    for (const AnalysisKind kind : {AnalysisKind::Frame2d, AnalysisKind::Grillage, AnalysisKind::Frame3d}) {
        CAPTURE(name(kind));
        const Model whole = random_structure(kind, 3);
        for (std::size_t i = 0; i < whole.members.size(); ++i) {
            Model model = whole;
            const double length = geometry_of(model, model.members[i]).length;
            const BentMember bent = bend_member(model, MemberId(i), {BendCurve::Parabola, 0.2 * length, 4});
            CHECK(errors_among(check(model)).empty()); // members of a grillage may cross
            CHECK(model.nodes.size() == whole.nodes.size() + 3);
            CHECK(bent.members.size() == 4);
        }
    }
}

TEST_CASE("No rise and no parts are refused, with the model as it was")
{
    Model model = beam(false);
    CHECK_THROWS_AS(bend_member(model, MemberId(0), {BendCurve::Arc, 0.0, 6}), std::invalid_argument);
    CHECK_THROWS_AS(bend_member(model, MemberId(0), {BendCurve::Parabola, 1e-7 * span, 6}), std::invalid_argument);
    CHECK_THROWS_AS(bend_member(model, MemberId(0), {BendCurve::Arc, 1.0, 1}), std::invalid_argument);
    CHECK(model.members.size() == 1);
    CHECK(model.nodes.size() == 2);
}

TEST_CASE("A load that stands at a length keeps its share of it, as one that stands at a percentage does")
{
    for (const Position& place : {Position(Quantity(0.29 * span)), Position(Percent{29.0})}) {
        Model model = beam(false);
        model.load_cases.front().members = {
            {MemberId(0), PointLoad{.at = place, .components = {{Dof::uy, Quantity(-40.0)}}}}};
        bend_member(model, MemberId(0), {BendCurve::Arc, 0.5 * span, 2});
        // The first of two parts at 45 degrees: 0.58 of it is 0.29 of the span; pinned supports bear it as a beam does.
        CHECK(reaction(model, NodeId(1), Dof::uy) == doctest::Approx(0.29 * 40.0));
    }
}

TEST_SUITE_END();
