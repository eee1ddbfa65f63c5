// What a load means: places, combinations, and its components in the member's axes.
#include <doctest/doctest.h>

#include "femoop/load/case_terms.h"
#include "femoop/load/load_components.h"
#include "femoop/load/place_along.h"
#include "femoop/load/span_loads.h"

using namespace femoop;

namespace {

constexpr double L = 6.5; // of a member that rises 5 for every 12: cos = 12/13, sin = 5/13
constexpr double cosine = 12.0 / 13.0, sine = 5.0 / 13.0;

MemberGeometry slope()
{
    return member_geometry(AnalysisKind::Frame2d, {1.0, 2.0, 0.0}, {1.0 + L * cosine, 2.0 + L * sine, 0.0},
                           Eigen::Vector3d::Zero());
}

/// The one load along an axis.
SpanLoad along_axis(const std::vector<SpanLoad>& loads, LocalAxis axis)
{
    SpanLoad found{.axis = axis};
    int n = 0;
    for (const SpanLoad& load : loads)
        if (load.axis == axis) {
            found = load;
            ++n;
        }
    CHECK(n == 1);
    return found;
}

std::vector<SpanLoad> read(const DistributedLoad& load)
{
    return span_loads({.member = {}, .load = load}, slope(), {});
}

} // namespace

TEST_CASE("A percentage is of the member's length, and what lies beyond an end is put there")
{
    CHECK(along(Percent{30.0}, L) == doctest::Approx(0.3 * L));
    CHECK(along(Quantity(1.7), L) == 1.7);
    CHECK(along(Quantity(-0.2), L) == 0.0);
    CHECK(along(Percent{104.0}, L) == L);
    CHECK(written_place(Percent{104.0}, L) == doctest::Approx(1.04 * L));
}

TEST_CASE("A load per metre of plan weighs less on a slope than one per metre of member")
{
    constexpr double q = -7.0;
    const auto per_member = read({.values = {{.dof = Dof::uy, .start = q}}});
    const auto per_plan = read({.values = {{.dof = Dof::uy, .start = q}}, .projected = true});
    CHECK(along_axis(per_member, LocalAxis::x).start == doctest::Approx(q * sine));
    CHECK(along_axis(per_member, LocalAxis::y).start == doctest::Approx(q * cosine));
    CHECK(along_axis(per_plan, LocalAxis::x).start == doctest::Approx(q * cosine * sine));
    CHECK(along_axis(per_plan, LocalAxis::y).end == doctest::Approx(q * cosine * cosine));
}

TEST_CASE("A load in the member's own axes is not turned, and begins and ends where it says")
{
    const auto loads = read({.values = {{.dof = Dof::uy, .start = 3.0, .end = Quantity(5.0)}},
                             .from = Percent{20.0},
                             .to = Quantity(6.1),
                             .axes = LoadAxes::Local});
    REQUIRE(loads.size() == 1);
    CHECK(loads[0].axis == LocalAxis::y);
    CHECK(loads[0].from == doctest::Approx(0.2 * L));
    CHECK(loads[0].to == 6.1);
    CHECK(loads[0].start == 3.0);
    CHECK(loads[0].end == 5.0);
}

TEST_CASE("Heat that differs over the depth lengthens the axis by what it is there, and bends the member")
{
    const MemberProperties properties{.alpha = 1.2e-5, .depth = 0.4, .centroid = 0.3};
    const auto loads = span_loads({.member = {}, .load = TemperatureLoad{.top = 30.0, .bottom = 10.0}}, slope(),
                                  properties);
    REQUIRE(loads.size() == 1);
    CHECK(loads[0].kind == SpanLoad::Kind::Strain);
    CHECK(loads[0].start == doctest::Approx(1.2e-5 * (10.0 + 20.0 * 0.3 / 0.4)));
    CHECK(loads[0].end == doctest::Approx(-1.2e-5 * 20.0 / 0.4));
}

TEST_CASE("A combination of combinations is multiplied out, and a load case that cancels is left out")
{
    Model model;
    for (const char* id : {"G", "Q", "W"}) model.load_cases.push_back({.id = id});
    const CaseId G(0), Q(1), W(2), inner(4);
    model.combinations.push_back({.id = "outer", .terms = {{G, 1.35}, {inner, 2.0}, {W, -3.0}}});
    model.combinations.push_back({.id = "inner", .terms = {{Q, 0.7}, {W, 1.5}}});
    const CaseTerms terms = terms_of(model, CaseId(3));
    CHECK(terms.name == "outer");
    REQUIRE(terms.terms.size() == 2);
    CHECK(terms.terms[0].load_case == G.index);
    CHECK(terms.terms[0].factor == 1.35);
    CHECK(terms.terms[1].load_case == Q.index);
    CHECK(terms.terms[1].factor == 1.4);
    CHECK(cases_of(model).size() == 5);
}

TEST_CASE("Of a case that the model lacks there is nothing, and what goes round in combinations adds nothing")
{
    Model model;
    model.load_cases.push_back({.id = "G"});
    const CaseId G(0), first(1), second(2), missing(9);
    model.combinations.push_back({.id = "first", .terms = {{G, 1.0}, {second, 1.0}, {missing, 1.0}}});
    model.combinations.push_back({.id = "second", .terms = {{G, 0.5}, {first, 1.0}}});
    CHECK(terms_of(model, missing).terms.empty());
    REQUIRE(terms_of(model, first).terms.size() == 1);
    CHECK(terms_of(model, first).terms[0].factor == 1.5);
}

TEST_CASE("A load's components say where they act and which way, whatever the axes")
{
    const MemberLoad ends{
        .member = {}, .load = EndLoads{.start = {{Dof::ux, 2.0}}, .end = {{Dof::rz, -3.0}}, .axes = LoadAxes::Local}};
    const auto components = components_of(ends, L);
    REQUIRE(components.size() == 2);
    CHECK(components[0].kind == LoadComponent::Kind::End);
    CHECK(components[0].from == 0.0);
    CHECK(components[1].from == L);
    CHECK(components[1].start == -3.0);
    CHECK((direction_of(components[0], slope()) - slope().axes.row(0).transpose()).norm() == 0.0);
    const MemberLoad wind{.member = {}, .load = PointLoad{.at = Percent{50.0}, .components = {{Dof::uy, 4.0}}}};
    CHECK(components_of(wind, L).at(0).from == 0.5 * L);
    CHECK(direction_of(components_of(wind, L).at(0), slope()) == Eigen::Vector3d::UnitY());
    CHECK(components_of({.member = {}, .load = Misfit{0.01}}, L).empty());
}
