#include "femoop/methods/force_method/force_method.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/derivation/derivation_text.h"
#include "femoop/methods/force_method/force_steps.h"
#include "femoop/methods/force_method/usual_redundants.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/result/components.h"
#include "tests/femoop/analysis/random_structure.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::force_method;

namespace {

constexpr double EI = 20000.0, L = 4.0, q = 12.0; // of the FrameMaker

Redundant reaction(const Model& model, std::string_view node, Dof dof)
{
    return {.quantity = ExpectedQuantity::Reaction, .node = model.find_node(node), .dof = dof};
}

Redundant section(const Model& model, std::string_view member, MemberComponent component, Position at)
{
    return {.quantity = ExpectedQuantity::SectionForce,
            .member = model.find_member(member),
            .component = component,
            .at = std::move(at)};
}

ForceMethod solved(const Model& model, const std::vector<Redundant>& redundants = {}, CaseId load_case = CaseId(0))
{
    return force_method::solve(model, analyse(model), load_case, redundants);
}

std::vector<std::string> names(const Model& model, const std::vector<Redundant>& redundants)
{
    std::vector<std::string> all;
    for (const Redundant& one : redundants) all.push_back(influence::effect_name(model, one));
    return all;
}

FaultKind fault_of(const Model& model, const std::vector<Redundant>& redundants)
{
    const std::vector<Fault> faults = check_redundants(model, redundants, "--force-method");
    REQUIRE(faults.size() == 1);
    return faults[0].kind;
}

FaultKind refusal(const Model& model, const std::vector<Redundant>& redundants)
{
    try {
        solved(model, redundants);
    } catch (const ModelError& error) {
        return error.faults().front().kind;
    }
    FAIL("nothing was refused");
    return {};
}

FrameMaker propped_cantilever()
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Fixed).node("B", L, 0, SupportKind::Roller).member("A", "B");
    return made;
}

FrameMaker two_spans()
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Pin)
        .node("B", L, 0, SupportKind::Roller)
        .node("C", 2 * L, 0, SupportKind::Roller);
    made.member("A", "B").member("B", "C").uniform("AB", -q).uniform("BC", -q);
    return made;
}

/// Feet at A and D, of height 3 and width 5.
FrameMaker portal(SupportKind feet)
{
    FrameMaker made;
    made.node("A", 0, 0, feet).node("B", 0, 3).node("C", 5, 3).node("D", 5, 0, feet);
    made.member("A", "B").member("B", "C").member("C", "D");
    return made;
}

/// Every force of a structure that could be released, in random order: sections at their members' ends and inside.
std::vector<Redundant> shuffled_forces(const Model& model, std::mt19937& generator)
{
    std::vector<Redundant> all;
    for (const Node& node : model.nodes)
        for (const Dof dof : dof_list(model.analysis)) all.push_back(reaction(model, node.id, dof));
    for (const Member& member : model.members)
        for (const MemberComponent component : section_force_components(model.analysis))
            for (const double at : {0.0, 37.0, 100.0}) all.push_back(section(model, member.id, component, Percent{at}));
    std::erase_if(all, [&](const Redundant& one) { return !check_redundants(model, {&one, 1}, {}).empty(); });
    std::shuffle(all.begin(), all.end(), generator);
    return all;
}

std::vector<Redundant> random_redundants(const Model& model, unsigned seed, std::size_t n)
{
    std::mt19937 generator(seed);
    std::vector<Redundant> chosen;
    for (const Redundant& one : shuffled_forces(model, generator)) {
        if (chosen.size() == n) break;
        chosen.push_back(one);
        if (!is_stable(model, chosen)) chosen.pop_back();
    }
    return chosen;
}

/// Values along a member of the whole structure, from the results of the primary one.
double value_along(const ForceMethod& method, const CaseResult& state, std::size_t member, MemberComponent component,
                   double percent)
{
    const std::vector<PrimaryStructure::Part>& parts = method.primary.parts[member];
    const double x = percent / 100.0 * parts.back().end;
    std::size_t i = 0;
    while (i + 1 < parts.size() && x > parts[i].end * (1.0 + 1e-12)) ++i;
    const double at = std::min(x - parts[i].begin, parts[i].end - parts[i].begin);
    return state.curve(parts[i].member).value(component, at, percent == 0.0 ? Side::After : Side::Before);
}

/// The sum of the states beside the direct analysis, along all members and at all nodes.
void check_superposition(const Model& model, const ForceMethod& method, const CaseResult& direct)
{
    for (const MemberComponent component : member_components(model.analysis)) {
        std::vector<double> sizes(method.cases.size(), 0.0);
        double error = 0.0;
        for (std::size_t m = 0; m < model.members.size(); ++m)
            for (const double percent : {0.0, 20.0, 37.0, 61.0, 100.0}) {
                const auto value = [&](const CaseResult& of) { return value_along(method, of, m, component, percent); };
                for (std::size_t i = 0; i < sizes.size(); ++i)
                    sizes[i] = std::max(sizes[i], std::abs(value(method.state(i))));
                const Curve curve = direct.curve(MemberId(m));
                const Side side = percent == 0.0 ? Side::After : Side::Before;
                error = std::max(error, std::abs(value(method.sum()) -
                                                 curve.value(component, percent / 100.0 * curve.length(), side)));
            }
        double size = sizes[0];
        for (std::size_t i = 1; i < sizes.size(); ++i)
            size += std::abs(method.X[static_cast<Eigen::Index>(i) - 1]) * sizes[i];
        CAPTURE(name(component, model.analysis));
        CHECK(error <= 1e-9 * size);
    }
}

/// A truss with one bar too many, pushed at D.
FrameMaker braced_panel()
{
    FrameMaker made;
    made.model.analysis = AnalysisKind::Truss2d;
    made.node("A", 0, 0, SupportKind::Pin).node("B", 3, 0, SupportKind::Roller).node("C", 0, 2).node("D", 3, 2);
    made.member("A", "B").member("A", "C").member("B", "D").member("C", "D").member("A", "D").member("B", "C");
    made.force("D", Dof::ux, 9.0);
    return made;
}

} // namespace

TEST_SUITE("force method")
{
    TEST_CASE("The prop of a cantilever under q takes 3 q L / 8")
    {
        const ForceMethod method = solved(propped_cantilever().uniform("AB", -q).model);
        CHECK(method.n_redundants() == 1);
        CHECK(method.delta_0[0] == doctest::Approx(-q * std::pow(L, 4) / (8.0 * EI)));
        CHECK(method.delta(0, 0) == doctest::Approx(std::pow(L, 3) / (3.0 * EI)));
        CHECK(method.X[0] == doctest::Approx(3.0 * q * L / 8.0));
        CHECK(method.sum().curve(MemberId(0)).value(MemberComponent::Mz, 0.0) == doctest::Approx(-q * L * L / 8.0));
    }

    TEST_CASE("The same with the moment at the clamped end: q L^2 / 8 by the rotation of a simple beam")
    {
        const Model model = propped_cantilever().uniform("AB", -q).model;
        const ForceMethod of_section = solved(model, {section(model, "AB", MemberComponent::Mz, Percent{0.0})});
        CHECK(of_section.delta_0[0] == doctest::Approx(q * std::pow(L, 3) / (24.0 * EI)));
        CHECK(of_section.delta(0, 0) == doctest::Approx(L / (3.0 * EI)));
        CHECK(of_section.X[0] == doctest::Approx(-q * L * L / 8.0));
        const ForceMethod of_support = solved(model, {reaction(model, "A", Dof::rz)});
        CHECK(of_support.X[0] == doctest::Approx(q * L * L / 8.0));
    }

    TEST_CASE("The middle support of two spans under q takes 5 q L / 4, and the moment there is q L^2 / 8")
    {
        const Model model = two_spans().model;
        const ForceMethod of_support = solved(model);
        REQUIRE(names(model, of_support.redundants) == std::vector<std::string>{"fy(B)"});
        CHECK(of_support.X[0] == doctest::Approx(5.0 * q * L / 4.0));
        const ForceMethod of_hinge = solved(model, {section(model, "BC", MemberComponent::Mz, Percent{0.0})});
        CHECK(of_hinge.X[0] == doctest::Approx(-q * L * L / 8.0));
        CHECK(of_hinge.delta(0, 0) == doctest::Approx(2.0 * L / (3.0 * EI)));
    }

    TEST_CASE(
        "The thrust of a two-hinged portal under q on its beam is q l^2 / (4 h (2 k + 3)), but for what N strains")
    {
        FrameMaker made = portal(SupportKind::Pin).uniform("BC", -q);
        made.model.sections[0].A = 1e4;
        const ForceMethod method = solved(made.model);
        const double l = 5.0, h = 3.0, k = h / l;
        CHECK(names(made.model, method.redundants) == std::vector<std::string>{"fx(D)"});
        CHECK(-method.X[0] == doctest::Approx(q * l * l / (4.0 * h * (2.0 * k + 3.0))));
    }

    TEST_CASE("A clamped portal has three redundants, and is solved by those of a foot or of a cut through its beam")
    {
        FrameMaker made = portal(SupportKind::Fixed).uniform("BC", -q).force("B", Dof::ux, 7.0);
        const ForceMethod of_foot = solved(made.model);
        CHECK(names(made.model, of_foot.redundants) == std::vector<std::string>{"fx(D)", "fy(D)", "mz(D)"});
        std::vector<Redundant> cut;
        for (const auto component : {MemberComponent::N, MemberComponent::Vy, MemberComponent::Mz})
            cut.push_back(section(made.model, "BC", component, Percent{40.0}));
        const ForceMethod of_cut = solved(made.model, cut);
        CHECK(of_cut.primary.parts[1].size() == 2);
        for (const ForceMethod* method : {&of_foot, &of_cut})
            for (Eigen::Index i = 0; i < 3; ++i) CHECK(method->X[i] == doctest::Approx(method->analysed[i]));
    }

    TEST_CASE("A settlement of a released support is closed by the equation, that of another one is a part of the gap")
    {
        Model model = propped_cantilever().model;
        const double c = -0.01;
        model.load_cases[0].settlements.push_back({NodeId(1), {{Dof::uy, Quantity(c)}}});
        const ForceMethod released = solved(model);
        CHECK(released.delta_0[0] == 0.0);
        CHECK(released.imposed[0] == c);
        CHECK(released.X[0] == doctest::Approx(3.0 * EI * c / std::pow(L, 3)));
        const ForceMethod held = solved(model, {reaction(model, "A", Dof::rz)});
        CHECK(held.imposed[0] == 0.0);
        CHECK(held.delta_0[0] == doctest::Approx(c / L));
        CHECK(held.X[0] == doctest::Approx(-3.0 * EI * c / (L * L)));
    }

    TEST_CASE("A spring's force strains the spring: 1 / k is a part of its own delta")
    {
        FrameMaker made = propped_cantilever().uniform("AB", -q);
        const double k = 700.0;
        made.model.nodes[1].support = Support{.springs = {{.dof = Dof::uy, .stiffness = k}}};
        const ForceMethod method = solved(made.model);
        CHECK(method.delta(0, 0) == doctest::Approx(std::pow(L, 3) / (3.0 * EI) + 1.0 / k));
        CHECK(method.X[0] == doctest::Approx(method.analysed[0]));
    }

    TEST_CASE("A redundant bar of a truss carries what its misfit and the loads open")
    {
        FrameMaker made = braced_panel();
        made.load("BC", Misfit{0.003});
        const ForceMethod method = solved(made.model);
        CHECK(names(made.model, method.redundants) == std::vector<std::string>{"N(BC, 0%)"});
        CHECK(method.X[0] == doctest::Approx(method.analysed[0]));
    }

    TEST_CASE("Fewer redundants than the degree leave an indeterminate primary structure, whose states still add up")
    {
        const Model model = portal(SupportKind::Fixed).uniform("BC", -q).model;
        const ForceMethod method = solved(model, {reaction(model, "A", Dof::rz)});
        CHECK(method.degree.total() == 3);
        CHECK(method.states.indeterminacy().total() == 2);
        CHECK(method.X[0] == doctest::Approx(method.analysed[0]));
    }

    TEST_CASE("Redundants without which the structure moves are refused with the motion")
    {
        const Model model = two_spans().model;
        const std::vector<Redundant> sideways{reaction(model, "A", Dof::ux)};
        CHECK_THROWS_AS(solved(model, sideways), MechanismError);
        CHECK(refusal(model, sideways) == FaultKind::PrimaryMoves);
        CHECK_FALSE(is_stable(model, sideways));
        CHECK(is_stable(model, std::vector{reaction(model, "B", Dof::uy)}));
    }

    TEST_CASE("What is no force, carries none, lies inside a bar or is named twice is no redundant")
    {
        Model model = two_spans().model;
        model.members[1].start.release.insert(Dof::rz);
        Redundant moved = reaction(model, "B", Dof::uy);
        moved.quantity = ExpectedQuantity::Displacement;
        CHECK(fault_of(model, {moved}) == FaultKind::RedundantNoForce);
        CHECK(fault_of(model, {reaction(model, "B", Dof::ux)}) == FaultKind::RedundantReleased);
        CHECK(fault_of(model, {section(model, "BC", MemberComponent::Mz, Percent{0.0})}) ==
              FaultKind::RedundantReleased);
        const Redundant prop = reaction(model, "B", Dof::uy);
        CHECK(fault_of(model, {prop, prop}) == FaultKind::RedundantTwice);
        model.members[0].bar = true;
        CHECK(fault_of(model, {section(model, "AB", MemberComponent::N, Percent{50.0})}) ==
              FaultKind::RedundantInsideBar);
        CHECK(fault_of(model, {section(model, "AB", MemberComponent::Mz, Percent{50.0})}) ==
              FaultKind::RedundantReleased);
    }

    TEST_CASE("A determinate structure has no redundants, and of too many none are chosen")
    {
        FrameMaker simple;
        simple.node("A", 0, 0, SupportKind::Pin).node("B", L, 0, SupportKind::Roller).member("A", "B");
        CHECK(refusal(simple.model, {}) == FaultKind::RedundantsNone);
        Model tall = storey_frame(3, 4);
        tall.add(LoadCase{.id = "P"});
        CHECK(refusal(tall, {}) == FaultKind::RedundantsTooMany);
    }

    TEST_CASE("The ground stays in the primary structure: one reaction is chosen where no other redundant is left")
    {
        FrameMaker made;
        made.node("A", 0, 0, SupportKind::Roller).node("B", 7.3, 0).member("A", "B").point("AB", 2.91, -100);
        made.model.nodes[1].support = Support{.fixed = {Dof::ux}};
        made.model.members[0].foundation = Quantity(5000.0);
        const Results direct = analyse(made.model);
        const ForceMethod method = force_method::solve(made.model, direct, CaseId(0), {});
        CHECK(names(made.model, method.redundants) == std::vector<std::string>{"fy(A)"});
        CHECK(method.X[0] == doctest::Approx(direct[CaseId(0)].reaction(NodeId(0))[index(Dof::uy)]).epsilon(1e-8));
        check_superposition(made.model, method, direct[CaseId(0)]);
    }

    TEST_CASE("A beam that the ground alone holds is parted by a hinge in its middle")
    {
        FrameMaker made;
        made.node("A", 0, 0).node("B", 7.3, 0).member("A", "B").point("AB", 2.91, -100);
        made.model.nodes[1].support = Support{.fixed = {Dof::ux}};
        made.model.members[0].foundation = Quantity(5000.0);
        const Results direct = analyse(made.model);
        const ForceMethod method = force_method::solve(made.model, direct, CaseId(0), {});
        CHECK(names(made.model, method.redundants) == std::vector<std::string>{"M(AB, 50%)"});
        check_superposition(made.model, method, direct[CaseId(0)]);
    }

    TEST_CASE("Redundants that strain nothing are refused: no equation gives them")
    {
        FrameMaker made;
        made.node("A", 0, 0, SupportKind::Pin).node("B", L, 0, SupportKind::Pin).member("A", "B").uniform("AB", -q);
        made.model.members[0].inextensible = true;
        CHECK(refusal(made.model, {}) == FaultKind::RedundantsUnstrained);
    }

    TEST_CASE("The usual redundants are as many as the degree, and leave a determinate structure")
    {
        for (const std::size_t storeys : {1U, 2U}) {
            Model model = storey_frame(2, storeys);
            model.add(LoadCase{.id = "P", .nodes = {{NodeId(3), {{Dof::ux, Quantity(5.0)}}}}});
            const ForceMethod method = solved(model);
            CHECK(method.n_redundants() == 6 * storeys);
            CHECK(method.states.indeterminacy().total() == 0);
            CHECK((method.X - method.analysed).norm() <= 1e-9 * method.analysed.norm());
        }
    }

    TEST_CASE("In any structure, with any redundants, the states add up to the direct analysis")
    {
        for (const AnalysisKind kind : every_model)
            for (unsigned seed = 1; seed <= 2; ++seed) {
                Model model = random_structure(kind, seed);
                model.combinations.push_back({.id = "ULS", .terms = {{CaseId(0), 1.35}, {CaseId(1), -1.5}}});
                const std::vector<Redundant> redundants = random_redundants(model, seed, 4);
                CAPTURE(femoop::name(kind));
                CAPTURE(seed);
                CAPTURE(names(model, redundants).size());
                REQUIRE(redundants.size() == 4);
                const Results direct = analyse(model);
                for (const CaseId load_case : {CaseId(0), CaseId(2)}) {
                    const ForceMethod method = force_method::solve(model, direct, load_case, redundants);
                    CHECK((method.X - method.analysed).cwiseAbs().maxCoeff() <=
                          1e-9 * method.analysed.cwiseAbs().maxCoeff());
                    check_superposition(model, method, direct[load_case]);
                }
            }
    }

    TEST_CASE("As steps: the parts of every gap add up to it, and the states to their sum")
    {
        Model model = portal(SupportKind::Fixed).uniform("BC", -q).force("B", Dof::ux, 7.0).model;
        model.nodes[3].support->springs.push_back({.dof = Dof::rz, .stiffness = 3000.0});
        model.nodes[3].support->kind = SupportKind::Custom;
        model.nodes[3].support->fixed = {Dof::ux, Dof::uy};
        const ForceMethod method = solved(model);
        const derivation::Derivation way = steps(method, model);
        CHECK(way.steps.size() == 10);
        for (const derivation::Step& step : way.steps)
            for (const derivation::NamedMatrix& matrix : step.matrices) {
                CAPTURE(matrix.symbol);
                const Eigen::MatrixXd& values = matrix.values;
                REQUIRE(static_cast<std::size_t>(values.rows()) == matrix.rows.size());
                REQUIRE(static_cast<std::size_t>(values.cols()) == matrix.columns.size());
                const double size = values.cwiseAbs().maxCoeff();
                if (step.kind == derivation::StepKind::Flexibility)
                    CHECK((values.topRows(values.rows() - 1).colwise().sum() - values.bottomRows(1)).norm() <=
                          1e-12 * size);
                if (step.kind == derivation::StepKind::StateSuperposition && matrix.symbol != "X")
                    CHECK((values.leftCols(values.cols() - 1).rowwise().sum() - values.rightCols(1)).norm() <=
                          1e-9 * size);
            }
    }

    TEST_CASE("The last step adds up as many states as there are redundants")
    {
        const auto last_sentence = [](int n_redundants) {
            FrameMaker made;
            made.node("0", 0, 0, SupportKind::Fixed);
            for (int i = 1; i <= n_redundants; ++i) {
                made.node(std::to_string(i), L * i, 0, SupportKind::Roller);
                made.member(std::to_string(i - 1), std::to_string(i), "-").uniform(made.model.members.back().id, -q);
            }
            const derivation::Derivation way = steps(solved(made.model), made.model);
            return derivation::sentence(way.steps.back(), made.model, english);
        };
        CHECK(last_sentence(1).find("S = S0 + X1 S1. Below") != std::string::npos);
        CHECK(last_sentence(2).find("S = S0 + X1 S1 + X2 S2. Below") != std::string::npos);
        CHECK(last_sentence(5).find("S = S0 + X1 S1 + .. + X5 S5. Below") != std::string::npos);
    }

    TEST_CASE("In the steps of a truss a bar has one axial force, one with a load along it three")
    {
        const auto rows = [](const Model& model) {
            for (const derivation::Step& step : steps(solved(model), model).steps)
                if (step.kind == derivation::StepKind::State) return step.matrices.front().rows;
            return std::vector<std::string>();
        };
        FrameMaker made = braced_panel();
        CHECK(rows(made.model) == std::vector<std::string>{"AB", "AC", "BD", "CD", "AD", "BC"});
        made.load("CD", PointLoad{.at = Quantity(1.3), .components = {{Dof::ux, 5.0}}});
        CHECK(rows(made.model) ==
              std::vector<std::string>{"AB", "AC", "BD", "CD, 0%", "CD, 50%", "CD, 100%", "AD", "BC"});
    }

    TEST_CASE("Gaps are symmetric: the work of state i on state j is that of j on i")
    {
        const Model model = random_structure(AnalysisKind::Frame3d, 2);
        const ForceMethod method = solved(model, random_redundants(model, 7, 3));
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                const auto work = [&](std::size_t real, std::size_t unit) {
                    return virtual_work::work_between({method.primary.model, method.states, method.cases[real + 1]},
                                                      {method.primary.model, method.states, method.cases[unit + 1]})
                        .sum();
                };
                CHECK(work(i, j) == doctest::Approx(work(j, i)));
            }
    }
}
