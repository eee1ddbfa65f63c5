#include <doctest/doctest.h>

#include <cmath>

#include "femoop/analysis/linear_static.h"
#include "tests/frame_maker.h"

using namespace femoop;

namespace {

/// A bent simple beam, statically determinate, at places that are not round.
FrameMaker bent_beam()
{
    FrameMaker made({.id = "s", .A = 0.00845, .Iz = 2.313e-4, .h = 0.4},
                    {.id = "steel", .E = 210e6, .alpha = Quantity(1.2e-5)});
    made.node("A", 0, 0, SupportKind::Pin).node("B", 7.3, 2.1).node("C", 13.7, 2.1);
    made.node("D", 15.1, -1.7, SupportKind::Roller).member("A", "B").member("B", "C").member("C", "D");
    return made;
}

void require_no_force(const Model& model)
{
    const CaseResult result = analyse(model).at("P");
    for (std::size_t i = 0; i < model.members.size(); ++i)
        for (const MemberComponent component : {MemberComponent::N, MemberComponent::Vy, MemberComponent::Mz}) {
            const Extremes extremes = result.curve(MemberId(i)).extremes(component);
            CHECK(extremes.max.value == 0.0);
            CHECK(extremes.min.value == 0.0);
        }
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        for (const double force : result.reaction(NodeId(i))) CHECK(force == 0.0);
}

} // namespace

TEST_SUITE("unstressed")
{
    TEST_CASE("A support that settles strains nothing in a statically determinate frame, to the last digit")
    {
        FrameMaker made = bent_beam();
        made.model.load_cases[0].settlements.push_back(
            {.node = *made.model.find_node("D"), .components = {{Dof::uy, -0.013}}});
        require_no_force(made.model);
        CHECK(analyse(made.model).at("P").displacement(*made.model.find_node("D"))[index(Dof::uy)] == -0.013);
    }

    TEST_CASE("Heat strains nothing in a statically determinate frame, and bends it as a free one")
    {
        FrameMaker made = bent_beam();
        made.load("BC", TemperatureLoad{.top = 23.0, .bottom = -17.0});
        require_no_force(made.model);
        const Curve curve = analyse(made.model).at("P").curve(*made.model.find_member("BC"));
        const double sag = curve.displacement(3.2).v - 0.5 * (curve.displacement(0.0).v + curve.displacement(6.4).v);
        CHECK(std::abs(sag) == doctest::Approx(1.2e-5 * 40.0 / 0.4 * 6.4 * 6.4 / 8.0).epsilon(1e-9)); // kappa L^2 / 8
    }

    TEST_CASE("The force of a spring that is very soft beside the beam is no rounding")
    {
        FrameMaker made; // EI 20000
        const double k = 1e-6;
        made.node("A", 0, 0, SupportKind::Pin)
            .node("B", 4, 0, SupportKind::Custom)
            .node("C", 8, 0, SupportKind::Roller);
        made.model.nodes[1].support->springs = {{.dof = Dof::uy, .stiffness = k}};
        made.member("A", "B").member("B", "C");
        made.model.load_cases[0].settlements.push_back({.node = NodeId(2), .components = {{Dof::uy, -0.01}}});
        const double force = analyse(made.model).at("P").reaction(NodeId(1))[index(Dof::uy)];
        CHECK(force == doctest::Approx(k * 0.005).epsilon(1e-6));
    }
}
