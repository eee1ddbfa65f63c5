#include <doctest/doctest.h>

#include <cmath>

#include "femoop/analysis/linear_static.h"
#include "tests/femoop/analysis/random_structure.h"
#include "tests/frame_maker.h"

using namespace femoop;

namespace {

constexpr double E = 2.1e8, A = 0.01, I = 1.3e-4, h = 4.0, b = 6.0, H = 12.0;

/// A fixed portal A-B-C-D with H to the right at B.
Model portal()
{
    FrameMaker made({.id = "s", .A = A, .Iz = I}, {.id = "steel", .E = E, .alpha = 1.2e-5});
    made.node("A", 0, 0, SupportKind::Fixed).node("B", 0, h).node("C", b, h).node("D", b, 0, SupportKind::Fixed);
    made.member("A", "B").member("B", "C").member("D", "C").force("B", Dof::ux, H);
    return made.model;
}

} // namespace

TEST_SUITE("constraints")
{
    TEST_CASE("What a plane section does not give does not strain: w and rx along a member are 0, not no number")
    {
        const Model model = portal(); // A and Iz alone
        const Curve beam = analyse(model).at("P").curve(MemberId(1));
        for (const double x : {0.0, 0.3 * b, b}) {
            CHECK(beam.displacement(x).w == 0.0);
            CHECK(beam.displacement(x).rx == 0.0);
            CHECK(std::isfinite(beam.displacement(x).v));
        }
    }

    TEST_CASE("A portal with a rigid beam sways H h^3 / 24 EI and bends its columns by H h / 4")
    {
        Model model = portal();
        model.members[0].inextensible = model.members[2].inextensible = true;
        model.members[1].rigid = true;
        const CaseResult result = analyse(model).at("P");
        CHECK(result.displacement(NodeId(1))[0] == doctest::Approx(H * h * h * h / (24.0 * E * I)));
        CHECK(result.displacement(NodeId(1))[5] == doctest::Approx(0.0).epsilon(1e-12));
        CHECK(result.reaction(NodeId(0))[5] == doctest::Approx(H * h / 4.0));
        CHECK(result.curve(MemberId(1)).forces(0.0).Mz == doctest::Approx(H * h / 4.0));
        CHECK(result.curve(MemberId(1)).forces(0.0).N == doctest::Approx(-H / 2.0));
        CHECK(result.curve(MemberId(0)).forces(0.0).N == doctest::Approx(H * h / 2.0 / b));
    }

    TEST_CASE("Inextensible members are the limit of very stiff ones")
    {
        Model exact = portal();
        for (Member& member : exact.members) member.inextensible = true;
        Model stiff = portal();
        stiff.sections[0].A = 1e7 * A;
        const Results a = analyse(exact), s = analyse(stiff);
        for (std::size_t i = 0; i < 3; ++i) {
            const SectionForces x = a.at("P").curve(MemberId(i)).forces(1.0),
                                y = s.at("P").curve(MemberId(i)).forces(1.0);
            CHECK(x.N == doctest::Approx(y.N).epsilon(1e-6));
            CHECK(x.Mz == doctest::Approx(y.Mz).epsilon(1e-6));
        }
        CHECK(a.at("P").curve(MemberId(1)).displacement(b).u == a.at("P").curve(MemberId(1)).displacement(0.0).u);
    }

    TEST_CASE("Two inextensible spans between fixed ends share a force as their stiffnesses EA / L")
    {
        Model model;
        model.add(Material{.id = "steel", .E = E});
        model.add(Section{.id = "s", .A = A, .Iz = I});
        for (const double x : {0.0, 4.0, 10.0}) model.add(Node{.id = std::to_string(x), .at = {x, 0.0, 0.0}});
        model.nodes[0].support = model.nodes[2].support = Support{.kind = SupportKind::Fixed};
        for (const std::size_t i : {0, 1})
            model.add(Member{.id = std::to_string(i),
                             .nodes = {NodeId(i), NodeId(i + 1)},
                             .material = MaterialId(0),
                             .section = SectionId(0),
                             .inextensible = true});
        model.add(LoadCase{.id = "P", .nodes = {{.node = NodeId(1), .components = {{.dof = Dof::ux, .value = 10.0}}}}});
        const CaseResult result = analyse(model).at("P");
        CHECK(result.reaction(NodeId(0))[0] == doctest::Approx(-6.0)); // (1/4) / (1/4 + 1/6)
        CHECK(result.reaction(NodeId(2))[0] == doctest::Approx(-4.0));
    }

    TEST_CASE("A settlement that inextensible members cannot follow is refused with their names")
    {
        Model model = portal();
        for (Member& member : model.members) member.inextensible = true;
        model.nodes[1].support = Support{.kind = SupportKind::Fixed};
        model.load_cases[0].settlements.push_back(
            {.node = NodeId(0), .components = {{.dof = Dof::uy, .value = -0.01}}});
        try {
            analyse(model);
            FAIL("AB cannot lengthen");
        } catch (const MechanismError&) {
            FAIL("this is no mechanism");
        } catch (const ModelError& error) {
            REQUIRE(error.faults().size() == 1);
            CHECK(error.faults()[0].kind == FaultKind::ConstraintConflict);
            CHECK(error.faults()[0].arguments.front() == "AB");
        }
    }

    TEST_CASE("Heat that only bends lengthens no inextensible member, whatever its depth is rounded to")
    {
        Model model = portal();
        for (Member& member : model.members) member.inextensible = true;
        for (int i = 0; i < 50; ++i) {
            model.sections[0].h = 0.2 + 0.3 * i / 49.0;
            model.load_cases[0].members = {{.member = MemberId(1), .load = TemperatureLoad{10.0, -10.0}}};
            for (const std::size_t top : {1U, 2U}) model.nodes[top].support = Support{.kind = SupportKind::Pin};
            CHECK_NOTHROW(analyse(model));
        }
    }

    TEST_CASE("A free inextensible member takes its temperature as a change of length")
    {
        Model model = portal();
        model.members[0].inextensible = true;
        model.load_cases[0].nodes.clear();
        model.load_cases[0].members.push_back({.member = MemberId(0), .load = TemperatureLoad{50.0, 50.0}});
        const CaseResult result = analyse(model).at("P");
        CHECK(result.displacement(NodeId(1))[1] == doctest::Approx(1.2e-5 * 50.0 * h));
    }

    TEST_CASE("An inextensible member turns a hinged node by its rigid arm")
    {
        constexpr double arm = 0.4, P = 7.0;
        Model model;
        model.add(Material{.id = "steel", .E = E});
        model.add(Section{.id = "s", .A = 0.01, .Iz = 8e-5});
        model.add(Node{.id = "A", .at = {0.0, 0.0, 0.0}, .support = Support{.kind = SupportKind::Fixed}});
        model.add(Node{.id = "B", .at = {b, 0.0, 0.0}});
        model.add(Node{.id = "C", .at = {b + h, 0.0, 0.0}, .support = Support{.kind = SupportKind::Fixed}});
        const Member common{.material = MaterialId(0), .section = SectionId(0)};
        for (std::size_t i = 0; i < 2; ++i) {
            Member member = common;
            member.id = i == 0 ? "AB" : "BC";
            member.nodes = {NodeId(i), NodeId(i + 1)};
            model.add(member);
        }
        model.members[0].end.release = model.members[1].start.release = model.members[1].end.release = {Dof::rz};
        model.members[1].start.offset = model.members[1].end.offset = {0.0, arm};
        model.members[1].inextensible = true;
        model.add(LoadCase{.id = "W"});
        model.load_cases[0].nodes.push_back({.node = NodeId(1), .components = {{.dof = Dof::ux, .value = P}}});
        const NodeVector u = analyse(model).at("W").displacement(NodeId(1));
        CHECK(u[0] == doctest::Approx(P * b / (E * 0.01)));
        CHECK(u[5] == doctest::Approx(u[0] / arm));
    }

    TEST_CASE("A rigid member hinged at one end follows its chord and carries no moment there")
    {
        Model model = portal();
        model.members[1].rigid = true;
        model.members[1].end.release = {Dof::rz};
        const CaseResult result = analyse(model).at("P");
        const Curve beam = result.curve(MemberId(1));
        CHECK(std::abs(beam.forces(b, Side::Before).Mz) < 1e-9 * H * h);
        const double chord = (result.displacement(NodeId(2))[1] - result.displacement(NodeId(1))[1]) / b;
        CHECK(result.displacement(NodeId(1))[5] == doctest::Approx(chord));
        CHECK(result.displacement(NodeId(2))[5] != doctest::Approx(chord));
    }

    TEST_CASE("Rigid members are the limit of very stiff ones, in every model with bending")
    {
        for (const AnalysisKind kind : {AnalysisKind::Frame2d, AnalysisKind::Grillage, AnalysisKind::Frame3d})
            for (unsigned seed = 1; seed <= 6; ++seed) {
                CAPTURE(name(kind));
                CAPTURE(seed);
                Model exact = random_structure(kind, seed);
                Model stiff = exact;
                std::size_t n_rigid = 0;
                stiff.add(Section{.id = "stiff", .A = 2e6, .Iz = 3e4, .Iy = 2e4, .J = 1e4});
                for (std::size_t i = 3; i < exact.members.size(); i += 7) {
                    for (Model* model : {&exact, &stiff}) {
                        Member& member = model->members[i];
                        member.bar = false;
                        member.depths.clear();
                        member.theory = BeamTheory::EulerBernoulli;
                        member.start.springs.clear();
                        member.end.springs.clear();
                        for (LoadCase& load_case : model->load_cases) {
                            load_case.self_weight = 0.0;
                            load_case.settlements.clear(); // rigid members between supports could not follow
                            std::erase_if(load_case.members, [&](const MemberLoad& load) {
                                return load.member == MemberId(i) &&
                                       (std::holds_alternative<TemperatureLoad>(load.load) ||
                                        std::holds_alternative<Misfit>(load.load));
                            });
                        }
                    }
                    exact.members[i].rigid = true;
                    stiff.members[i].section = SectionId(stiff.sections.size() - 1);
                    ++n_rigid;
                }
                REQUIRE(n_rigid > 0);
                const CaseResult a = analyse(exact).at("P"), s = analyse(stiff).at("P");
                double largest = 0.0, apart = 0.0;
                for (std::size_t i = 0; i < exact.nodes.size(); ++i)
                    for (std::size_t k = 0; k < n_dofs; ++k) {
                        largest = std::max(largest, std::abs(a.displacement(NodeId(i))[k]));
                        apart = std::max(apart, std::abs(a.displacement(NodeId(i))[k] - s.displacement(NodeId(i))[k]));
                    }
                CHECK(apart < 1e-3 * largest);
                const Equilibrium e = a.equilibrium();
                for (std::size_t i = 0; i < n_dofs; ++i)
                    CHECK(std::abs(e.sum_loads[i] + e.sum_reactions[i]) < 1e-6 * (1.0 + std::abs(e.sum_loads[i])));
            }
    }
}
