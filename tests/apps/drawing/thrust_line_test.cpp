// The line of thrust: an arch that is its own, a column's straight one, and where there is none.
#include "apps/drawing/results/thrust_line.h"

#include <doctest/doctest.h>

#include <cmath>

#include "femoop/analysis/linear_static.h"
#include "femoop/edit/bend.h"

using namespace femoop;
using drawing::ThrustLine;
using Eigen::Vector3d;

namespace {

Model plane_model()
{
    Model model;
    model.add(Material{.id = "m", .E = 1e8});
    model.add(Section{.id = "s", .A = 1e-1, .Iz = 1e-3});
    model.load_cases.push_back({.id = "G"});
    return model;
}

void add_member(Model& model, std::size_t a, std::size_t b)
{
    model.add(Member{.id = "M" + std::to_string(model.members.size()),
                     .nodes = {NodeId(a), NodeId(b)},
                     .material = MaterialId(0),
                     .section = SectionId(0)});
}

std::vector<ThrustLine> thrust_lines(const Model& model)
{
    const Results results = analyse(model);
    const auto solved = drawing::solved_case(results, CaseId(0));
    const drawing::StructureShape shape = drawing::shape_of(model);
    std::vector<ThrustLine> lines;
    for (std::size_t i = 0; i < model.members.size(); ++i)
        lines.push_back(drawing::thrust_line(shape.members[i], (*solved)[MemberId(i)],
                                             {.axial_force = 1e-6, .eccentricity = 0.5 * shape.size}));
    return lines;
}

} // namespace

TEST_SUITE("drawing")
{
    TEST_CASE("A parabola under a load of its projection is its own line of thrust")
    {
        constexpr double rise = 5.0;
        Model model = plane_model();
        for (const double x : {0.0, 20.0})
            model.add(Node{.id = "N" + std::to_string(model.nodes.size()),
                           .at = {x, 0.0, 0.0},
                           .support = Support{.fixed = {Dof::ux, Dof::uy}}});
        add_member(model, 0, 1);
        DistributedLoad load{.values = {{Dof::uy, -12.0, std::nullopt}}};
        load.projected = true;
        model.load_cases.front().members.push_back({MemberId(0), load});
        bend_member(model, MemberId(0), {BendCurve::Parabola, rise, 48});
        for (const ThrustLine& line : thrust_lines(model)) {
            REQUIRE(line.parts.size() == 1);
            CHECK(line.largest_eccentricity < 0.02 * rise);
        }
    }

    TEST_CASE("In a column without loads it is straight, and is the line on which the reaction acts")
    {
        Model model = plane_model();
        model.add(Node{.id = "A", .at = {0.0, 0.0, 0.0}, .support = Support{.fixed = {Dof::ux, Dof::uy, Dof::rz}}});
        model.add(Node{.id = "B", .at = {0.0, 4.0, 0.0}});
        add_member(model, 0, 1);
        // 30 down and 6 to the right at the top: 24 kN m at the foot, 0.8 m from the axis.
        model.load_cases.front().nodes.push_back({NodeId(1), {{Dof::ux, 6.0}, {Dof::uy, -30.0}}});
        const ThrustLine line = thrust_lines(model).front();
        REQUIRE(line.parts.size() == 1);
        CHECK((line.parts.front().front() - Vector3d(0.8, 0.0, 0.0)).norm() < 1e-9);
        CHECK((line.parts.front().back() - Vector3d(0.0, 4.0, 0.0)).norm() < 1e-9);
        for (const Vector3d& place : line.parts.front())
            CHECK(std::abs(6.0 * (4.0 - place.y()) - 30.0 * place.x()) < 1e-9);
        CHECK(line.largest_eccentricity == doctest::Approx(0.8));
    }

    TEST_CASE("A beam without axial force has none")
    {
        Model model = plane_model();
        model.add(Node{.id = "A", .at = {0.0, 0.0, 0.0}, .support = Support{.fixed = {Dof::ux, Dof::uy}}});
        model.add(Node{.id = "B", .at = {6.0, 0.0, 0.0}, .support = Support{.fixed = {Dof::uy}}});
        add_member(model, 0, 1);
        model.load_cases.front().members.push_back(
            {MemberId(0), DistributedLoad{.values = {{Dof::uy, -12.0, std::nullopt}}}});
        CHECK(thrust_lines(model).front().parts.empty());
    }
}
