#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "femoop/analysis/linear_static.h"
#include "femoop/analysis/trace.h"
#include "femoop/discretisation/equations.h"
#include "femoop/element/analysis_model.h"
#include "femoop/io/derivation/derivation_text.h"
#include "femoop/methods/derivation/derivation.h"
#include "femoop/methods/derivation/renumbering.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/result/components.h"
#include "femoop/tabular/latex.h"
#include "tests/femoop/analysis/random_structure.h"
#include "tests/frame_maker.h"
#include "tests/samples.h"

using namespace femoop;
using namespace femoop::derivation;

namespace {

constexpr double EI = 20000.0, EA = 2e6, L = 4.0, q = 12.0; // of the FrameMaker

/// A beam that is fixed at A and on a roller at B, its load all along.
Model propped_beam()
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Fixed).node("B", L, 0, SupportKind::Roller).member("A", "B").uniform("AB", -q);
    return made.model;
}

MovingEffect along(MemberComponent component, std::optional<Position> at = {})
{
    MovingEffect effect{.quantity = is_displacement(component) ? ExpectedQuantity::Displacement
                                                               : ExpectedQuantity::SectionForce,
                        .member = MemberId(0),
                        .component = component,
                        .at = at};
    if (!at) effect.quantity = ExpectedQuantity::Extreme;
    return effect;
}

MovingEffect of_node(NodeId node, ExpectedQuantity quantity, Dof dof)
{
    return {.quantity = quantity, .node = node, .dof = dof};
}

Derivation derived(const Model& model, const MovingEffect& effect, CaseId load_case = CaseId(0))
{
    return derive(model, analyse(model), load_case, effect);
}

const Step& step_of(const Derivation& derivation, StepKind kind)
{
    const auto found = std::ranges::find(derivation.steps, kind, &Step::kind);
    REQUIRE(found != derivation.steps.end());
    return *found;
}

const NamedMatrix& matrix(const Derivation& derivation, StepKind kind, const std::string& symbol)
{
    const std::vector<NamedMatrix>& all = step_of(derivation, kind).matrices;
    const auto found = std::ranges::find(all, symbol, &NamedMatrix::symbol);
    REQUIRE(found != all.end());
    return *found;
}

double number(const NamedMatrix& matrix, const std::string& row, Eigen::Index column = 0)
{
    const auto found = std::ranges::find(matrix.rows, row);
    REQUIRE(found != matrix.rows.end());
    return matrix.values(found - matrix.rows.begin(), column);
}

/// The largest number that the last sum is made of.
double size_of_last(const Derivation& derivation)
{
    return derivation.steps.back().matrices.back().values.cwiseAbs().maxCoeff();
}

/// What the last step comes to is what the analysis says.
void check_closes(const Model& model, const Results& results, const MovingEffect& effect)
{
    for (std::size_t c = 0; c < model.n_cases(); ++c) {
        const Derivation derivation = derive(model, results, CaseId(c), effect);
        CAPTURE(derivation_text(derivation, model, english));
        if (derivation.value != 0.0)
            CHECK(derivation.value == influence::effect_in(derivation.effect, results[CaseId(c)]));
        CHECK(derivation.closing_error <= 1e-9 * std::max(size_of_last(derivation), 1e-12));
    }
}

/// Each number of k' is one of the entries, but for its sign, or 0.
void check_reproduced(const NamedMatrix& k, const NamedMatrix& entries)
{
    const double size = k.values.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < k.values.rows(); ++i)
        for (Eigen::Index j = 0; j < k.values.cols(); ++j) {
            const double value = std::abs(k.values(i, j));
            if (value <= 1e-12 * size) continue;
            CAPTURE(k.rows[static_cast<std::size_t>(i)]);
            CAPTURE(k.columns[static_cast<std::size_t>(j)]);
            CAPTURE(value);
            const double nearest = (entries.values.array().abs() - value).abs().minCoeff();
            CHECK(nearest <= 1e-9 * value);
        }
}

double as_written(double value, int digits)
{
    std::array<char, 40> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "%.*g", digits, value));
    return std::atof(text.data());
}

/// On a foundation with joints or shear beside it, for which the step has words alone.
bool has_words_alone(const NamedMatrix& entries)
{
    const auto any = [&](std::string_view part) {
        return std::ranges::any_of(entries.rows, [&](const std::string& row) { return row.find(part) < row.size(); });
    };
    return any("β L") && !any("sinh");
}

} // namespace

TEST_SUITE("derivation")
{
    TEST_CASE("The moment in a propped beam is q L^2 / 16, of its ends' motion and of its loads")
    {
        const Derivation derivation = derived(propped_beam(), along(MemberComponent::Mz, Percent{50.0}));
        const double rotation = q * L * L * L / (48.0 * EI); // of B, counter-clockwise
        CHECK(derivation.value == doctest::Approx(q * L * L / 16.0));

        const NamedMatrix& entries = matrix(derivation, StepKind::LocalStiffness, "entries");
        CHECK(number(entries, "EA/L") == doctest::Approx(EA / L));
        CHECK(number(entries, "12 EI/L^3") == doctest::Approx(12.0 * EI / (L * L * L)));
        CHECK(number(entries, "6 EI/L^2") == doctest::Approx(6.0 * EI / (L * L)));
        CHECK(number(entries, "4 EI/L") == doctest::Approx(4.0 * EI / L));
        CHECK(number(entries, "2 EI/L") == doctest::Approx(2.0 * EI / L));

        const NamedMatrix& K = matrix(derivation, StepKind::Equations, "K");
        CHECK(K.rows == std::vector<std::string>{"B.ux", "B.rz"});
        CHECK(K.values(1, 1) == doctest::Approx(4.0 * EI / L));
        CHECK(number(matrix(derivation, StepKind::Equations, "u"), "B.rz") == doctest::Approx(rotation));
        CHECK(number(matrix(derivation, StepKind::Equations, "f"), "B.rz") == doctest::Approx(q * L * L / 12.0));

        const NamedMatrix& forces = matrix(derivation, StepKind::EndForces, "p'");
        CHECK(number(forces, "A.rz'", 0) == doctest::Approx(2.0 * EI / L * rotation));
        CHECK(number(forces, "A.rz'", 1) == doctest::Approx(q * L * L / 12.0));
        CHECK(number(forces, "A.rz'", 2) == doctest::Approx(q * L * L / 8.0));

        const NamedMatrix& parts = derivation.steps.back().matrices.back();
        CHECK(number(parts, "f0'") == doctest::Approx(q * L * L / 24.0));
        CHECK(number(parts, "u'") == doctest::Approx(q * L * L / 48.0));
    }

    TEST_CASE("A member that shears has (4 + φ) EI / (L (1 + φ)) in its stiffness")
    {
        Model model = propped_beam();
        model.members[0].theory = BeamTheory::Timoshenko;
        model.materials[0].nu = 0.25;
        const Derivation derivation = derived(model, along(MemberComponent::Mz, Percent{50.0}));
        const NamedMatrix& entries = matrix(derivation, StepKind::LocalStiffness, "entries");
        const NamedMatrix& k = matrix(derivation, StepKind::LocalStiffness, "k'");
        CHECK(number(entries, "(4 + φ) EI/(L (1 + φ))") == doctest::Approx(k.values(2, 2)));
        CHECK(number(entries, "(2 - φ) EI/(L (1 + φ))") == doctest::Approx(k.values(2, 5)));
        CHECK(number(entries, "12 EI/(L^3 (1 + φ))") == doctest::Approx(k.values(1, 1)));
        CHECK(number(entries, "φ = 12 EI/(GAs L^2)") > 0.0);
    }

    TEST_CASE("A hinge leaves 3 EI/L^3, 3 EI/L^2 and 3 EI/L of a member's stiffness, two leave EA/L alone")
    {
        Model model = propped_beam();
        model.members[0].end.release = {Dof::rz};
        const MovingEffect asked = of_node(NodeId(0), ExpectedQuantity::Reaction, Dof::ux);
        const Derivation derivation = derived(model, asked);
        const NamedMatrix& entries = matrix(derivation, StepKind::LocalStiffness, "entries");
        CHECK(entries.rows == std::vector<std::string>{"EA/L", "3 EI/L^3", "3 EI/L^2", "3 EI/L"});
        CHECK(number(entries, "3 EI/L^3") == doctest::Approx(3.0 * EI / (L * L * L)));
        CHECK(number(entries, "3 EI/L^2") == doctest::Approx(3.0 * EI / (L * L)));
        CHECK(number(entries, "3 EI/L") == doctest::Approx(3.0 * EI / L));
        CHECK(number(matrix(derivation, StepKind::Member, "data"), "k(B.rz')") == 0.0);
        const std::string text = derivation_text(derivation, model, english);
        CHECK(text.find("Released at its ends, k = 0: B.rz'.") != std::string::npos);

        model.nodes[1].support = Support{.kind = SupportKind::Fixed};
        model.members[0].start.release = {Dof::rz};
        const std::vector<std::string> axial{"EA/L"};
        CHECK(matrix(derived(model, asked), StepKind::LocalStiffness, "entries").rows == axial);
    }

    TEST_CASE("A spring of k = 3 EI/L at an end has the fixity factor 1/2, and D = 4 - r1 r2")
    {
        Model model = propped_beam();
        model.members[0].end.springs = {{Dof::rz, Quantity(3.0 * EI / L)}};
        const Derivation derivation = derived(model, of_node(NodeId(0), ExpectedQuantity::Reaction, Dof::uy));
        const NamedMatrix& entries = matrix(derivation, StepKind::LocalStiffness, "entries");
        CHECK(number(matrix(derivation, StepKind::Member, "data"), "k(B.rz')") == doctest::Approx(3.0 * EI / L));
        CHECK(number(entries, "r1") == 1.0);
        CHECK(number(entries, "r2 = 1/(1 + 3 EI/(L k(B.rz')))") == doctest::Approx(0.5));
        CHECK(number(entries, "D = 4 - r1 r2") == doctest::Approx(3.5));
        CHECK(number(entries, "12 EI r1/(L D)") == doctest::Approx(12.0 / 3.5 * EI / L));
        CHECK(number(entries, "6 EI r1 r2/(L D)") == doctest::Approx(3.0 / 3.5 * EI / L));
    }

    TEST_CASE("A beam on a foundation has β and Hetenyi's functions of β L, short and long")
    {
        for (const double beta_L : {1e-3, 0.3, 0.999, 1.001, 4.0, 50.0, 900.0}) {
            CAPTURE(beta_L);
            Model model = propped_beam();
            model.members[0].foundation = Quantity(4.0 * EI * std::pow(beta_L / L, 4.0));
            const Derivation derivation = derived(model, of_node(NodeId(0), ExpectedQuantity::Reaction, Dof::uy));
            const NamedMatrix& entries = matrix(derivation, StepKind::LocalStiffness, "entries");
            CHECK(number(entries, "β L") == doctest::Approx(beta_L));
            CHECK(derivation_latex(derivation, model, english).find("\\ensuremath{\\beta} L") != std::string::npos);
            check_reproduced(matrix(derivation, StepKind::LocalStiffness, "k'"), entries);
        }
    }

    TEST_CASE("A taper has the law of EI between its ends, and k' is the inverse of its flexibilities")
    {
        Model model = propped_beam();
        SectionShape rectangle;
        rectangle.b = 0.3;
        rectangle.h = 0.6;
        model.sections[0] = Section{.id = "s", .shape = rectangle};
        model.members[0].depths = {Quantity(0.6), Quantity(0.2)};
        const Derivation derivation = derived(model, of_node(NodeId(0), ExpectedQuantity::Reaction, Dof::uy));
        const NamedMatrix& data = matrix(derivation, StepKind::Member, "data");
        const double a1 = number(data, "a1"), a2 = number(data, "a2"), a3 = number(data, "a3");
        const auto EI_at = [&](double x) { return number(data, "EI(0)") * (1.0 + x * (a1 + x * (a2 + x * a3))); };
        CHECK(EI_at(L) == doctest::Approx(number(data, "EI(L)")));
        CHECK(EI_at(0.5 * L) == doctest::Approx(2e8 * 0.3 * 0.4 * 0.4 * 0.4 / 12.0));

        const NamedMatrix& entries = matrix(derivation, StepKind::LocalStiffness, "entries");
        constexpr int n = 2000; // strips, each by Simpson's rule
        double f1 = 0.0, f2 = 0.0, f12 = 0.0;
        for (int i = 0; i <= 2 * n; ++i) {
            const double t = i / (2.0 * n), weight = (i == 0 || i == 2 * n ? 1.0 : i % 2 == 0 ? 2.0 : 4.0);
            const double dx = weight * L / (6.0 * n) / EI_at(t * L);
            f1 += (1.0 - t) * (1.0 - t) * dx;
            f2 += t * t * dx;
            f12 -= (1.0 - t) * t * dx;
        }
        CHECK(number(entries, "f1 = ∫ (1 - x/L)^2 dx/EI") == doctest::Approx(f1).epsilon(1e-9));
        CHECK(number(entries, "f2 = ∫ (x/L)^2 dx/EI") == doctest::Approx(f2).epsilon(1e-9));
        CHECK(number(entries, "f12 = -∫ (1 - x/L) x/L dx/EI") == doctest::Approx(f12).epsilon(1e-9));
        CHECK(number(entries, "f2/D") == doctest::Approx(f2 / (f1 * f2 - f12 * f12)).epsilon(1e-8));
    }

    TEST_CASE("Each number of any member's k' is one of its entries: hinged, on springs, tapered, sheared, in space")
    {
        std::size_t n_checked = 0;
        for (const AnalysisKind kind : every_model)
            for (unsigned seed = 1; seed <= samples(4, 1); ++seed) {
                const Model model = random_structure(kind, seed);
                CAPTURE(name(kind));
                CAPTURE(seed);
                const Results results = analyse(model);
                for (std::size_t m = 0; m < model.members.size(); ++m) {
                    MovingEffect effect = along(member_components(kind).front(), Percent{37.0});
                    effect.member = MemberId(m);
                    const Derivation derivation = derive(model, results, CaseId(0), effect);
                    CAPTURE(model.members[m].id);
                    const std::vector<NamedMatrix>& all = step_of(derivation, StepKind::LocalStiffness).matrices;
                    if (has_words_alone(all.front())) continue;
                    check_reproduced(all.back(), all.front());
                    n_checked += all.size() - 1;
                }
            }
        CHECK(n_checked > 100);
    }

    TEST_CASE("A rotation comes from a row of K, made of its members and its spring, and a row of f")
    {
        Model model = propped_beam();
        model.nodes[1].support->kind = SupportKind::Custom;
        model.nodes[1].support->fixed = {Dof::uy};
        model.nodes[1].support->springs = {{Dof::rz, Quantity(5000.0)}};
        const Derivation derivation = derived(model, of_node(NodeId(1), ExpectedQuantity::Displacement, Dof::rz));
        const NamedMatrix& row = matrix(derivation, StepKind::StiffnessRow, "K");
        CHECK(row.rows == std::vector<std::string>{"AB", "spring", "B.rz"});
        CHECK(row.values(2, row.values.cols() - 1) == doctest::Approx(4.0 * EI / L + 5000.0));
        CHECK(number(matrix(derivation, StepKind::LoadRow, "f"), "f") == doctest::Approx(q * L * L / 12.0));
        CHECK(derivation.value == doctest::Approx(q * L * L / 12.0 / (4.0 * EI / L + 5000.0)));
    }

    TEST_CASE("A reaction is what the members need at the node, less the load on it")
    {
        Model model = propped_beam();
        model.load_cases[0].nodes.push_back({NodeId(1), {{Dof::uy, Quantity(-7.0)}}});
        const Derivation derivation = derived(model, of_node(NodeId(1), ExpectedQuantity::Reaction, Dof::uy));
        CHECK(derivation.value == doctest::Approx(3.0 / 8.0 * q * L + 7.0));
        const NamedMatrix& sum = matrix(derivation, StepKind::Reaction, "fy(B)");
        CHECK(number(sum, "AB") == doctest::Approx(3.0 / 8.0 * q * L));
        CHECK(number(sum, "-F") == doctest::Approx(7.0));
        CHECK(derivation.closing_error < 1e-12);
    }

    TEST_CASE("The extreme of a moment is followed to its place")
    {
        const Derivation derivation = derived(propped_beam(), along(MemberComponent::Mz));
        CHECK(derivation.value == doctest::Approx(-q * L * L / 8.0)); // at the fixed end, greater than 9 q L^2 / 128
        CHECK(matrix(derivation, StepKind::Extreme, "extremes").values(0, 0) == doctest::Approx(5.0 / 8.0 * L));
        CHECK(derivation.closing_error < 1e-12);
    }

    TEST_CASE("A displacement that a support imposes is no unknown")
    {
        Model model = propped_beam();
        model.load_cases[0].settlements.push_back({NodeId(1), {{Dof::uy, Quantity(-0.01)}}});
        const Derivation held = derived(model, of_node(NodeId(1), ExpectedQuantity::Displacement, Dof::uy));
        CHECK(held.steps.back().kind == StepKind::Held);
        CHECK(held.steps.back().matrices.back().values(0, 0) == doctest::Approx(-0.01));
        const Derivation free = derived(model, of_node(NodeId(1), ExpectedQuantity::Displacement, Dof::rz));
        const NamedMatrix& f = matrix(free, StepKind::LoadRow, "f");
        CHECK(number(f, "-k u AB") == doctest::Approx(-6.0 * EI / (L * L) * 0.01));
        CHECK(number(f, "f") == doctest::Approx(number(matrix(free, StepKind::Equations, "f"), "B.rz")));
    }

    TEST_CASE("A combination adds up its load cases, each with its own steps")
    {
        Model model = propped_beam();
        model.add(LoadCase{.id = "Q", .nodes = {{NodeId(1), {{Dof::rz, Quantity(30.0)}}}}});
        model.combinations.push_back({.id = "ULS", .terms = {{CaseId(0), 1.35}, {CaseId(1), 1.5}}});
        const Derivation derivation = derived(model, along(MemberComponent::Mz, Percent{0.0}), CaseId(2));
        CHECK(derivation.value == doctest::Approx(-1.35 * q * L * L / 8.0 - 1.5 * 30.0 / 2.0));
        CHECK(derivation.steps.back().kind == StepKind::Combination);
        CHECK(derivation.closing_error < 1e-10);
        CHECK(std::ranges::count(derivation.steps, StepKind::Member, &Step::kind) == 1);
        CHECK(std::ranges::count(derivation.steps, StepKind::EndForces, &Step::kind) == 2);
    }

    TEST_CASE("Where supports hold every node there are no equations, and none are written")
    {
        Model model = propped_beam();
        model.nodes[1].support = Support{.kind = SupportKind::Fixed};
        const Derivation derivation = derived(model, along(MemberComponent::Mz, Percent{50.0}));
        CHECK(derivation.value == doctest::Approx(q * L * L / 24.0));
        CHECK(std::ranges::none_of(derivation.steps, [](const Step& step) {
            return step.kind == StepKind::RightHandSide || step.kind == StepKind::Equations;
        }));
    }

    TEST_CASE("Of an envelope the largest and the smallest extreme are each of the case that has it")
    {
        // down, V falls from 5/8 q L to -3/8 q L; up by half, from -5/16 q L to 3/16 q L
        Model model = propped_beam();
        model.combinations.push_back({.id = "up", .terms = {{CaseId(0), -0.5}}});
        const Results results = analyse(model);
        MovingEffect shear = along(MemberComponent::Vy, Percent{0.0});
        shear.at.reset();
        shear.quantity = ExpectedQuantity::Extreme;
        const Derivation derivation = derive_governing(model, results, {CaseId(1), CaseId(0)}, shear);
        const NamedMatrix& range = matrix(derivation, StepKind::Governing, "envelope");
        CHECK(range.rows == std::vector{model.case_name(CaseId(0)), model.case_name(CaseId(0))});
        CHECK(range.values(0, 0) == doctest::Approx(5.0 / 8.0 * q * L));
        CHECK(range.values(1, 0) == doctest::Approx(-3.0 / 8.0 * q * L));

        const MovingEffect resultant{.quantity = ExpectedQuantity::Reaction, .node = NodeId(0)};
        CHECK(derive_governing(model, results, {CaseId(1), CaseId(0)}, resultant).value ==
              doctest::Approx(5.0 / 8.0 * q * L));
    }

    TEST_CASE("Of a large system the rows that matter are written, and they hold")
    {
        Model model = storey_frame(3, 4);
        model.add(LoadCase{.id = "W", .nodes = {{NodeId(19), {{Dof::ux, Quantity(10.0)}}}}});
        const Derivation derivation = derived(model, of_node(NodeId(9), ExpectedQuantity::Displacement, Dof::ux));
        const NamedMatrix& K = matrix(derivation, StepKind::Equations, "K");
        CHECK(K.rows == std::vector<std::string>{"9.ux"});
        CHECK(K.columns.size() < 5 * 3 + 1);
        CHECK_FALSE(step_of(derivation, StepKind::Equations).is_whole);
        const Eigen::VectorXd force = K.values * matrix(derivation, StepKind::Equations, "u").values;
        CHECK(force[0] == doctest::Approx(0.0).epsilon(1e-6 * K.values.cwiseAbs().maxCoeff()));
    }

    TEST_CASE("A moment between two hinges of a member in space is 0, not round-off, and so are its parts")
    {
        FrameMaker made({.id = "s", .A = 0.0527, .Iz = 4.22e-4, .Iy = 1.27e-4, .J = 3.3e-4});
        made.node("A", 0, 0, SupportKind::Fixed).node("B", 0.3, 0.2).node("C", 4.1, 0.9).node("D", 4.6, 3.7);
        made.member("C", "D").member("A", "B").member("B", "C").force("B", Dof::ux, 7.7).force("C", Dof::uz, -9.1);
        Model& model = made.model;
        model.analysis = AnalysisKind::Frame3d;
        for (const auto& [node, z] :
             {std::pair(std::size_t{1}, 3.7), std::pair(std::size_t{2}, 3.9), std::pair(std::size_t{3}, -0.2)})
            model.nodes[node].at[2] = z;
        model.nodes[3].support = Support{.kind = SupportKind::Pin};
        model.members[0].start.release.insert(Dof::ry);
        const Derivation derivation = derived(model, along(MemberComponent::My, Percent{31.0}));
        CAPTURE(derivation_text(derivation, model, english));
        CHECK(derivation.value == 0.0);
        CHECK(number(derivation.steps.back().matrices.back(), "u'") == 0.0);
        CHECK(number(derivation.steps.back().matrices.back(), "f0'") == 0.0);
    }

    TEST_CASE("In any structure every number closes")
    {
        const std::size_t step = samples(2, 3);
        for (const AnalysisKind kind : every_model)
            for (unsigned seed = 1; seed <= samples(2, 1); ++seed) {
                const Model model = random_structure(kind, seed);
                CAPTURE(name(kind));
                CAPTURE(seed);
                const Results results = analyse(model);
                for (std::size_t m = seed % step; m < model.members.size(); m += step)
                    for (const MemberComponent component : member_components(kind)) {
                        MovingEffect effect = along(component, Percent{37.0});
                        effect.member = MemberId(m);
                        check_closes(model, results, effect);
                    }
                for (std::size_t n = seed % step; n < model.nodes.size(); n += step)
                    for (const Dof dof : dof_list(kind)) {
                        check_closes(model, results, of_node(NodeId(n), ExpectedQuantity::Displacement, dof));
                        if (results[CaseId(0)].is_supported(NodeId(n)))
                            check_closes(model, results, of_node(NodeId(n), ExpectedQuantity::Reaction, dof));
                    }
            }
    }

    TEST_CASE("The system on paper is the one that is solved")
    {
        for (const AnalysisKind kind : every_model) {
            const Model model = random_structure(kind, 3);
            CAPTURE(name(kind));
            const SystemTrace system = trace_system(model);
            const Eigen::MatrixXd K = system.K;
            CHECK((K - K.transpose()).norm() == 0.0);
            for (std::size_t m = 0; m < model.members.size(); ++m) {
                const MemberTrace member = trace(model, MemberId(m));
                for (std::size_t i = 0; i < member.equations.size(); ++i)
                    if (const int row = member.equations[i]; row > 0) {
                        const auto& [node, dof, end_of] = system.unknowns[static_cast<std::size_t>(row - 1)];
                        CHECK(member.dofs[i] == model[node].id + "." + std::string(name(dof)));
                    }
            }
        }
    }

    TEST_CASE("A row of members that is numbered crosswise is renumbered to the band of a row")
    {
        FrameMaker made;
        made.node("A", 0, 0, SupportKind::Fixed)
            .node("D", 3 * L, 0)
            .node("B", L, 0)
            .node("E", 4 * L, 0)
            .node("C", 2 * L, 0);
        made.member("A", "B").member("B", "C").member("C", "D").member("D", "E");
        const Renumbering found = renumbering_of(trace_system(made.model));
        // D B E C, three unknowns each: of the axial and the bending ones of two neighbours a row has five entries
        CHECK(found.solver == SolverKind::Skyline);
        CHECK(found.ordering == Ordering::CuthillMcKee);
        CHECK(found.given.half_bandwidth > found.solved.half_bandwidth);
        CHECK(found.solved.half_bandwidth == 5);
        CHECK(found.solved.profile < found.given.profile);
        CHECK(found.solved.factor < found.given.factor);
        CHECK_FALSE(found.is_no_gain());
    }

    TEST_CASE("The order that is told is the one that the solver takes")
    {
        const Model frame = storey_frame(3, 4);
        const Discretisation structure = discretise(frame);
        const Elements elements(structure);
        const Equations equations(structure, elements, SolverKind::Automatic);
        const SystemTrace system = trace_system(frame);
        for (std::size_t i = 0; i < system.unknowns.size(); ++i) {
            const auto dofs = model_dofs(frame.analysis);
            const auto dof = std::ranges::find(dofs, system.unknowns[i].dof) - dofs.begin();
            CHECK(system.place[i] == equations.of(system.unknowns[i].node, static_cast<std::size_t>(dof)));
        }
        const SystemTrace eliminated = as_eliminated(system);
        CHECK(Eigen::MatrixXd(eliminated.K).norm() == doctest::Approx(Eigen::MatrixXd(system.K).norm()));
    }

    TEST_CASE("A reaction begins with the data: each member at the node, the equations, displacements, end forces")
    {
        Model model = propped_beam();
        model.load_cases[0].settlements.push_back({NodeId(1), {{Dof::uy, Quantity(-0.01)}}});
        const Derivation derivation = derived(model, of_node(NodeId(1), ExpectedQuantity::Reaction, Dof::uy));
        std::vector<StepKind> kinds;
        for (const Step& step : derivation.steps) kinds.push_back(step.kind);
        using enum StepKind;
        CHECK(kinds == std::vector{Member, LocalStiffness, Transformation, Stiffness, Numbering, FixedEndForces, Held,
                                   RightHandSide, Equations, EndDisplacements, NodeForces, Reaction});
        CHECK(derivation.value == doctest::Approx(3.0 / 8.0 * q * L - 3.0 * EI / (L * L * L) * 0.01));
        const NamedMatrix& f = matrix(derivation, RightHandSide, "f");
        CHECK(f.columns == std::vector<std::string>{"-f0", "supports", "f"});
        CHECK(number(f, "B.rz", 0) == doctest::Approx(q * L * L / 12.0));
        CHECK(number(f, "B.rz", 1) == doctest::Approx(-6.0 * EI / (L * L) * 0.01));
    }

    TEST_CASE("The reaction of a spring is its stiffness times its displacement, as its members say")
    {
        Model model = propped_beam();
        model.nodes[1].support->kind = SupportKind::Custom;
        model.nodes[1].support->springs = {{Dof::uy, Quantity(900.0)}};
        model.load_cases[0].settlements.push_back({NodeId(1), {{Dof::uy, Quantity(-0.02)}}});
        const Derivation derivation = derived(model, of_node(NodeId(1), ExpectedQuantity::Reaction, Dof::uy));
        const NamedMatrix& spring = matrix(derivation, StepKind::Reaction, "spring");
        CHECK(number(spring, "ground") == -0.02);
        CHECK(number(spring, "k (ground - u)") == doctest::Approx(derivation.value));
        CHECK(number(spring, "k (ground - u)") == doctest::Approx(900.0 * (-0.02 - number(spring, "u"))));
        CHECK(derivation.closing_error < 1e-9);
    }

    TEST_CASE("Of a portal whose members do not stretch sway and two rotations are left, and the ties carry its thrust")
    {
        constexpr double h = 3.0, l = 5.0, H = 8.0;
        FrameMaker made;
        made.node("A", 0, 0, SupportKind::Fixed).node("B", 0, h).node("C", l, h).node("D", l, 0, SupportKind::Fixed);
        made.member("A", "B").member("B", "C").member("C", "D");
        made.model.load_cases[0].nodes.push_back({NodeId(1), {{Dof::ux, Quantity(H)}}});
        for (femoop::Member& member : made.model.members) member.inextensible = true;
        MovingEffect thrust = along(MemberComponent::N, Percent{50.0});
        thrust.member = MemberId(1);
        const Derivation derivation = derived(made.model, thrust);
        CHECK(derivation.value == doctest::Approx(-H / 2.0)); // by antimetry
        const NamedMatrix& C = matrix(derivation, StepKind::Ties, "C");
        CHECK(C.rows == std::vector<std::string>{"AB", "BC", "CD"});
        CHECK(matrix(derivation, StepKind::Ties, "G").columns.size() == 3);
        const NamedMatrix& K = matrix(derivation, StepKind::ReducedEquations, "G^T K G");
        CHECK(K.values(0, 0) == doctest::Approx(2.0 * 12.0 * EI / (h * h * h))); // two columns sway
        CHECK(number(derivation.steps.back().matrices.back(), "c'") == doctest::Approx(-H / 2.0));
        CHECK(derivation.closing_error < 1e-12);

        const auto says_worked_in = [&] {
            const std::string text = derivation_text(derived(made.model, thrust), made.model, english);
            return text.find("Releases and springs at its ends are worked in.") != std::string::npos;
        };
        CHECK(says_worked_in());
        made.model.members[1].end.release = {Dof::rz};
        CHECK_FALSE(says_worked_in()); // C of BC turns by an unknown of its own
        made.model.members[1].end.release = {};

        const Derivation sway = derived(made.model, of_node(NodeId(2), ExpectedQuantity::Displacement, Dof::ux));
        const bool follows = sway.steps.back().kind == StepKind::TiedDisplacement;
        CHECK((follows || sway.steps.back().kind == StepKind::ReducedEquations));
        CHECK(sway.value ==
              doctest::Approx(derived(made.model, of_node(NodeId(1), ExpectedQuantity::Displacement, Dof::ux)).value));
    }

    TEST_CASE("K of tied members, put together from their own k, is that of the system")
    {
        for (const AnalysisKind kind : every_model)
            for (unsigned seed = 1; seed <= 4; ++seed) {
                const Model model = random_structure(kind, seed);
                CAPTURE(name(kind));
                CAPTURE(seed);
                const SystemTrace system = trace_system(model);
                Eigen::MatrixXd K = system.K;
                const double size = K.cwiseAbs().maxCoeff();
                for (std::size_t m = 0; m < model.members.size(); ++m) {
                    const MemberTrace member = trace(model, MemberId(m));
                    for (std::size_t i = 0; i < member.equations.size(); ++i)
                        for (std::size_t j = 0; j < member.equations.size(); ++j)
                            if (member.equations[i] > 0 && member.equations[j] > 0)
                                K(member.equations[i] - 1, member.equations[j] - 1) -= member.global_stiffness(
                                    static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
                }
                const Eigen::VectorXd springs = K.diagonal();
                K.diagonal().setZero();
                CHECK(K.cwiseAbs().maxCoeff() <= 1e-12 * size);
                CHECK(springs.minCoeff() >= -1e-12 * size);
            }
    }

    TEST_CASE("The resultant of a slanting support has the steps of both components and is their root")
    {
        Model model = propped_beam();
        model.nodes[1].support->angle = Quantity(30.0);
        model.load_cases[0].nodes.push_back({NodeId(1), {{Dof::ux, Quantity(5.0)}}});
        const MovingEffect resultant{.quantity = ExpectedQuantity::Reaction, .node = NodeId(1)};
        const Derivation derivation = derived(model, resultant);
        const Derivation fx = derived(model, of_node(NodeId(1), ExpectedQuantity::Reaction, Dof::ux));
        const Derivation fy = derived(model, of_node(NodeId(1), ExpectedQuantity::Reaction, Dof::uy));
        CHECK(fy.value == doctest::Approx(-fx.value * std::sqrt(3.0))); // along the normal of the support
        CHECK(derivation.value == doctest::Approx(std::hypot(fx.value, fy.value)));
        CHECK(derivation.steps.size() == fx.steps.size() + 2);
        const NamedMatrix& sum = step_of(derivation, StepKind::Resultant).matrices[0];
        CHECK(sum.rows == std::vector<std::string>{"fx(B)", "fy(B)", "R(B)"});
        CHECK(sum.values(2, 0) == derivation.value);
        CHECK(derivation_title(derivation, model, english).starts_with("R(B) = "));
    }

    TEST_CASE("A difference has the steps of both cases, what is common but once, and of another model its value")
    {
        FrameMaker made;
        made.node("A", 0, 0, SupportKind::Fixed).node("B", L, 0, SupportKind::Roller).member("A", "B");
        made.uniform("AB", -q);
        Model model = made.model;
        model.load_cases.push_back(model.load_cases[0]);
        model.load_cases[1].id = "half";
        auto& half = std::get<DistributedLoad>(model.load_cases[1].members[0].load).values[0];
        half.start = Quantity(-0.5 * q);
        half.end = half.start;
        const MovingEffect middle = along(MemberComponent::Mz, Percent{50.0});
        const Results results = analyse(model);
        const double now = q * L * L / 16.0; // of a propped beam in the middle
        const Derivation both = derive_difference(model, results, CaseId(0), CaseId(1), middle);
        CHECK(both.value == doctest::Approx(0.5 * now));
        CHECK(std::ranges::count(both.steps, StepKind::Superposition, &Step::kind) == 2);
        CHECK(std::ranges::count(both.steps, StepKind::LocalStiffness, &Step::kind) == 1);
        CHECK(both.steps.back().matrices[0].values(2, 0) == doctest::Approx(0.5 * now));
        const Derivation other = derive_difference(model, results, CaseId(0), 0.25 * now, middle);
        CHECK(other.value == doctest::Approx(0.75 * now));
        CHECK(std::ranges::count(other.steps, StepKind::Superposition, &Step::kind) == 1);
        CHECK(number_name(both, "M(AB, 50%)") == "ΔM(AB, 50%)");
    }

    TEST_CASE("A length keeps its digits beside a stiffness")
    {
        Model model = propped_beam();
        model.nodes[1].at[0] = Quantity(4.25);
        const std::string text = derivation_text(derived(model, along(MemberComponent::Mz, Percent{50.0})), model,
                                                 english);
        CHECK(text.find(" 4.25\n") != std::string::npos);
        CHECK(text.find(" 2e+06\n") != std::string::npos);
    }

    TEST_CASE("A taper's D = f1 f2 - f12^2 is written beside stiffnesses 1e12 times as large")
    {
        Model model = propped_beam();
        SectionShape rectangle;
        rectangle.b = 0.3;
        rectangle.h = 0.9;
        model.sections[0] = Section{.id = "s", .shape = rectangle};
        model.members[0].depths = {Quantity(0.9), Quantity(0.45)};
        const Derivation derivation = derived(model, along(MemberComponent::Mz, Percent{50.0}));
        const NamedMatrix& entries = matrix(derivation, StepKind::LocalStiffness, "entries");
        const double f1 = number(entries, "f1 = ∫ (1 - x/L)^2 dx/EI"), f2 = number(entries, "f2 = ∫ (x/L)^2 dx/EI"),
                     f12 = number(entries, "f12 = -∫ (1 - x/L) x/L dx/EI");
        REQUIRE(f1 * f2 - f12 * f12 < 1e-12 * number(entries, "f1/D"));
        const std::string D = six_digits(f1 * f2 - f12 * f12, english);
        CHECK(derivation_text(derivation, model, english).find(" " + D + "\n") != std::string::npos);
        CHECK(derivation_latex(derivation, model, english).find(" & " + tabular::latex_text(D) + " ") !=
              std::string::npos);
    }

    TEST_CASE("Where both ends move together u' has the digits by which k' u' comes out as it is written")
    {
        FrameMaker made({.id = "s", .A = 0.0128, .Iz = 1.2e-4});
        made.node("A", 0, 0, SupportKind::Fixed).node("B", 0, 4).node("C", 6, 4).node("D", 6.1, 0, SupportKind::Fixed);
        made.member("A", "B").member("B", "C").member("D", "C").uniform("BC", -3.0);
        made.model.load_cases[0].settlements.push_back({NodeId(3), {{Dof::ux, Quantity(-0.02)}}});
        for (std::size_t m = 0; m < 3; ++m) {
            MovingEffect effect = along(MemberComponent::N, Percent{50.0});
            effect.member = MemberId(m);
            const Derivation derivation = derived(made.model, effect);
            const NamedMatrix& k = matrix(derivation, StepKind::LocalStiffness, "k'");
            const NamedMatrix& u = matrix(derivation, StepKind::EndDisplacements, "u'");
            const NamedMatrix& p = matrix(derivation, StepKind::EndForces, "p'");
            for (const int usual : {4, 6}) {
                CAPTURE(derivation_text(derivation, made.model, english));
                CAPTURE(usual);
                const double size = p.values.col(0).cwiseAbs().maxCoeff();
                CHECK(std::max(k.more_digits, u.more_digits) <= 6);
                for (Eigen::Index i = 0; i < k.values.rows(); ++i) {
                    double sum = 0.0;
                    for (Eigen::Index j = 0; j < k.values.cols(); ++j)
                        sum += as_written(k.values(i, j), written_digits(k, usual)) *
                               as_written(u.values(j, 0), written_digits(u, usual));
                    CHECK(std::abs(sum - p.values(i, 0)) <= 5.0 * std::pow(10.0, 1 - usual) * size);
                }
            }
        }
    }

    TEST_CASE("As LaTeX a derivation has every step, its matrices in brackets, and its own entries of K in bold")
    {
        const Model beam = propped_beam();
        const std::string text = derivation_latex(derived(beam, along(MemberComponent::Mz, Percent{50.0})), beam,
                                                  english);
        CHECK(text.starts_with("% \\usepackage{amsmath}\n\\section*{M(AB, 50\\%) = 12 kN\\ensuremath{\\cdot}m in "));
        CHECK(text.find("\\paragraph{11.}") != std::string::npos);
        CHECK(text.find("EI/L\\ensuremath{^3} & 3750") != std::string::npos);
        CHECK(text.find("k' = \\begin{bmatrix}\n500000 & 0 & 0 & -500000 & 0 & 0") != std::string::npos);
        // of k the rows of B.ux and B.rz go to K
        CHECK(text.find("-500000 & 0 & 0 & \\mathbf{500000} & 0 & 0") != std::string::npos);
        CHECK(text.find("0 & 7500 & 10000 & 0 & -7500 & \\mathbf{20000}") != std::string::npos);
    }

    TEST_CASE("LaTeX leaves no decimal comma that would be followed by a blank")
    {
        const Model beam = propped_beam();
        const Translator comma = [](std::string_view text) {
            return text == "." ? std::string(",") : std::string(text);
        };
        const std::string text = derivation_latex(derived(beam, along(MemberComponent::Mz, Percent{50.0})), beam,
                                                  comma);
        CHECK(text.find("\\mathbf{0{,}0008}") != std::string::npos); // q L^3 / 48 EI
    }

    TEST_CASE("What stands beside the numbers is in the reader's language, but for ids and letters of formulas")
    {
        const Model beam = propped_beam();
        const Translator shouted = [](std::string_view text) {
            return text == "data" ? "DATA" : text == "entries" ? "ENTRIES" : std::string(text);
        };
        const Derivation derivation = derived(beam, along(MemberComponent::Mz, Percent{50.0}));
        for (const std::string& text :
             {derivation_text(derivation, beam, shouted), derivation_latex(derivation, beam, shouted)}) {
            CHECK(text.find("DATA") != std::string::npos);
            CHECK(text.find("ENTRIES") != std::string::npos);
            CHECK(text.find("data") == std::string::npos);
        }
    }
}
