#include "femoop/methods/virtual_work/virtual_work.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/result/components.h"
#include "tests/femoop/analysis/random_structure.h"
#include "tests/frame_maker.h"
#include "tests/samples.h"

using namespace femoop;
using namespace femoop::virtual_work;

namespace {

constexpr double EI = 20000.0, EA = 2e6, L = 4.0, q = 12.0, P = 30.0; // of the FrameMaker

MovingEffect of_node(std::size_t node, Dof dof)
{
    return {.quantity = ExpectedQuantity::Displacement, .node = NodeId(node), .dof = dof};
}

MovingEffect along(std::size_t member, MemberComponent component, Position at)
{
    return {.quantity = ExpectedQuantity::Displacement,
            .member = MemberId(member),
            .component = component,
            .at = std::move(at)};
}

VirtualWork worked(const Model& model, const MovingEffect& displacement, CaseId load_case = CaseId(0))
{
    return displacement_by_work(model, analyse(model), load_case, displacement);
}

Model cantilever()
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Fixed).node("B", L, 0).member("A", "B");
    return made.model;
}

/// Of what the displacement is made of.
double size_of(const Work& work)
{
    double size = 0.0;
    for (const WorkIntegral& one : work.integrals) size += std::abs(one.value);
    for (const JointWork& one : work.joints) size += std::abs(one.value);
    for (const SupportWork& one : work.supports) size += std::abs(one.value);
    return size;
}

/// One case of a structure whose displacements are all found by work as well.
class Checked {
public:
    Checked(const Model& model, CaseId load_case)
        : model_(model),
          results_(analyse(model)),
          load_case_(load_case),
          rounding_(1e-13 * results_[load_case].magnitudes().displacement)
    {}

    void check(const MovingEffect& displacement) const
    {
        CAPTURE(influence::effect_name(model_, displacement));
        try {
            const VirtualWork work = displacement_by_work(model_, results_, load_case_, displacement);
            CHECK(std::abs(work.sum - work.value) <= 1e-9 * size_of(work.work) + rounding_);
        } catch (const MechanismError&) { // nothing holds a rotation that no member feels
            CHECK(is_rotation(displacement.dof.value()));
        }
    }

private:
    const Model& model_;
    Results results_;
    CaseId load_case_;
    double rounding_;
};

} // namespace

TEST_SUITE("virtual work")
{
    TEST_CASE("The tip of a cantilever under P sinks by the integral of (L - x) P (L - x) / EI")
    {
        Model model = cantilever();
        model.load_cases[0].nodes.push_back({NodeId(1), {{Dof::uy, Quantity(-P)}}});
        const VirtualWork work = worked(model, of_node(1, Dof::uy));
        REQUIRE(work.work.integrals.size() == 1);
        const WorkIntegral& integral = work.work.integrals[0];
        CHECK(integral.force == MemberComponent::Mz);
        CHECK(integral.flexibility == doctest::Approx(1.0 / EI));
        CHECK(integral.real[0] == doctest::Approx(-P * L));
        CHECK(integral.real[1] == doctest::Approx(P));
        CHECK(integral.unit[0] == doctest::Approx(L));
        CHECK(integral.unit[1] == doctest::Approx(-1.0));
        CHECK(integral.value == doctest::Approx(-P * L * L * L / (3.0 * EI)));
        CHECK(work.sum == doctest::Approx(work.value));
    }

    TEST_CASE("Under a uniform load it turns by q L^3 / 6 EI")
    {
        Model model = cantilever();
        model.load_cases[0].members.push_back(
            {MemberId(0), DistributedLoad{.values = {{.dof = Dof::uy, .start = Quantity(-q)}}}});
        CHECK(worked(model, of_node(1, Dof::rz)).sum == doctest::Approx(-q * L * L * L / (6.0 * EI)));
    }

    TEST_CASE("Shear adds P L / GAs, in an integral of its own")
    {
        Model model = cantilever();
        model.members[0].theory = BeamTheory::Timoshenko;
        model.materials[0].nu = 0.25;
        const double GAs = 2e8 / 2.5 * 0.004;
        model.load_cases[0].nodes.push_back({NodeId(1), {{Dof::uy, Quantity(-P)}}});
        const VirtualWork work = worked(model, of_node(1, Dof::uy));
        REQUIRE(work.work.integrals.size() == 2);
        CHECK(work.work.integrals[0].force == MemberComponent::Vy);
        CHECK(work.work.integrals[0].value == doctest::Approx(-P * L / GAs));
        CHECK(work.sum == doctest::Approx(work.value));
    }

    TEST_CASE("Heat works on the unit load's forces: alpha T L along the axis, kappa L^2 / 2 across")
    {
        Model model = cantilever();
        model.materials[0].alpha = Quantity(1.2e-5);
        model.sections[0].h = Quantity(0.3);
        model.load_cases[0].members.push_back({MemberId(0), TemperatureLoad{Quantity(10.0), Quantity(40.0)}});
        CHECK(worked(model, of_node(1, Dof::ux)).sum == doctest::Approx(1.2e-5 * 25.0 * L));
        const VirtualWork across = worked(model, of_node(1, Dof::uy));
        CHECK(across.sum == doctest::Approx(1.2e-5 * 30.0 / 0.3 * L * L / 2.0));
        REQUIRE(across.work.integrals.size() == 1);
        CHECK(across.work.integrals[0].strain == doctest::Approx(1.2e-5 * 30.0 / 0.3));
    }

    TEST_CASE("A settlement does the work of the unit load's reaction on it")
    {
        FrameMaker made;
        made.node("A", 0, 0, SupportKind::Pin).node("B", L, 0, SupportKind::Roller).member("A", "B");
        made.model.load_cases[0].settlements.push_back({NodeId(1), {{Dof::uy, Quantity(-0.01)}}});
        const VirtualWork work = worked(made.model, along(0, MemberComponent::v, Percent{25.0}));
        CHECK(work.work.integrals.empty());
        REQUIRE(work.work.supports.size() == 1);
        CHECK(work.work.supports[0].displacement == doctest::Approx(-0.01));
        CHECK(work.work.supports[0].reaction == doctest::Approx(-0.25));
        CHECK(work.sum == doctest::Approx(-0.0025));
    }

    TEST_CASE("A truss: the sum of N n L / EA")
    {
        FrameMaker made;
        made.model.analysis = AnalysisKind::Truss2d;
        made.node("A", 0, 0, SupportKind::Pin).node("B", 0, 3, SupportKind::Pin).node("C", 4, 0);
        made.member("A", "C").member("B", "C").force("C", Dof::uy, -P);
        const VirtualWork work = worked(made.model, of_node(2, Dof::uy));
        // sin = 3/5: N(BC) = P / sin, N(AC) = -P / tan
        const double stretched = P * 25.0 / 9.0 * 5.0, pressed = P * 16.0 / 9.0 * 4.0;
        CHECK(work.work.of(MemberId(1)) == doctest::Approx(-stretched / EA));
        CHECK(work.work.of(MemberId(0)) == doctest::Approx(-pressed / EA));
        CHECK(work.sum == doctest::Approx(work.value));
    }

    TEST_CASE("Two forces exchange their works: Betti and Maxwell")
    {
        Model model = storey_frame(2, 2);
        model.add(LoadCase{.id = "one", .nodes = {{NodeId(8), {{Dof::ux, Quantity(1.0)}}}}});
        const double there = worked(model, of_node(4, Dof::uy)).sum;
        model.load_cases[0].nodes = {{NodeId(4), {{Dof::uy, Quantity(1.0)}}}};
        CHECK(worked(model, of_node(8, Dof::ux)).sum == doctest::Approx(there));
    }

    TEST_CASE("In any structure the work is the displacement of the analysis")
    {
        for (const AnalysisKind kind : every_model)
            for (unsigned seed = 1; seed <= samples(2, 1); ++seed) {
                Model model = random_structure(kind, seed);
                model.combinations.push_back({.id = "ULS", .terms = {{CaseId(0), 1.35}, {CaseId(1), -1.5}}});
                CAPTURE(name(kind));
                CAPTURE(seed);
                const Checked checked(model, CaseId(2));
                for (std::size_t m = 0; m < model.members.size(); ++m)
                    for (const MemberComponent component : local_displacement_components(kind))
                        checked.check(along(m, component, Percent{m % 2 == 0 ? 37.0 : 0.0}));
                for (std::size_t n = 0; n < model.nodes.size(); ++n)
                    for (const Dof dof : dof_list(kind)) checked.check(of_node(n, dof));
            }
    }
}
