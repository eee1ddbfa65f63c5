// Half of a symmetric structure is balanced; its states are those of the whole.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "femoop/methods/cross/comparison.h"
#include "femoop/methods/cross/slope_deflection.h"
#include "femoop/methods/cross/state_model.h"
#include "femoop/methods/cross/superposition.h"
#include "femoop/methods/cross/symmetry.h"
#include "femoop/methods/cross/turns.h"
#include "femoop/methods/dice.h"
#include "femoop/model/fault/fault_kind.h"
#include "tests/femoop/methods/cross/frames.h"

using namespace femoop;
using namespace femoop::cross;
using doctest::Approx;

namespace {

constexpr double H = 4, B = 7, q = 12, W = 30; // of the portals

FrameMaker symmetric_portal()
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 0, H).node("C", B, H).node("D", B, 0, fixed);
    made.member("A", "B").member("B", "C").member("D", "C");
    return made;
}

Problem half_of(const Model& model, FarEnds far_ends = FarEnds::Modified)
{
    return problem_of(model, CaseId(0), far_ends, Extent::Half);
}

double moment_at(const Problem& problem, const std::vector<double>& moments, std::string_view end)
{
    return moments[problem.find_end(end)->index];
}

/// Storeys and bays with sections, bases and widths that are their own mirror images, and loads of one kind: opposite
/// ones leave the middle bay empty. Pushed from the left or not.
struct RandomFrame {
    explicit RandomFrame(unsigned seed) : dice(seed)
    {
        for (const double times : {1.0, 2.0, 3.5})
            made.model.add(Section{.id = "I" + std::to_string(times), .A = 0.01, .Iz = times * 1e-4, .Asy = 0.004});
        n_bays = static_cast<int>(dice.roll(1, 4));
        n_storeys = static_cast<int>(dice.roll(1, 3));
        kind = dice.sign();
        add_nodes();
        for (int storey = 1; storey <= n_storeys; ++storey) add_storey(storey);
    }

    static std::string name(int line, int level) { return std::to_string(line) + "/" + std::to_string(level); }
    int image(int line) const { return n_bays - line; }

    void add_nodes()
    {
        std::vector<double> width(static_cast<std::size_t>(n_bays));
        for (int i = 0; i < n_bays; ++i) {
            const int other = n_bays - 1 - i;
            width[static_cast<std::size_t>(i)] = other < i ? width[static_cast<std::size_t>(other)] : dice.roll(3, 9);
        }
        std::vector<SupportKind> base(static_cast<std::size_t>(n_bays) + 1);
        double x = -4.0;
        for (int line = 0; line <= n_bays; ++line) {
            const auto i = static_cast<std::size_t>(line), j = static_cast<std::size_t>(image(line));
            base[i] = j < i ? base[j] : dice.sign() > 0 ? fixed : pin;
            for (int level = 0; level <= n_storeys; ++level)
                made.node(name(line, level), x, 3.5 * level, level == 0 ? std::optional(base[i]) : std::nullopt);
            if (line < n_bays) x += width[i];
        }
    }

    void join(int a, int level_a, int b, int level_b)
    {
        made.member(name(a, level_a), name(b, level_b));
        Member& member = made.model.members.back();
        const bool is_beam = a != b;
        const auto other = made.model.find_member(is_beam ? name(image(b), level_b) + name(image(a), level_a)
                                                          : name(image(a), level_a) + name(image(b), level_b));
        const bool has_image = other && made.model[*other].id != member.id;
        member.section = has_image ? made.model[*other].section : SectionId(static_cast<std::size_t>(dice.roll(1, 3)));
        if (has_image ? made.model[*other].theory == BeamTheory::Timoshenko : dice.roll(0, 3) == 0.0)
            member.theory = BeamTheory::Timoshenko;
    }

    void add_storey(int level)
    {
        for (int line = 0; line <= n_bays; ++line) join(line, level - 1, line, level);
        std::vector<double> load(static_cast<std::size_t>(n_bays));
        for (int bay = 0; bay < n_bays; ++bay) {
            const int other = n_bays - 1 - bay;
            const auto i = static_cast<std::size_t>(bay), j = static_cast<std::size_t>(other);
            join(bay, level, bay + 1, level);
            load[i] = other < bay ? -kind * load[j] : other == bay && kind > 0 ? 0.0 : dice.roll(5, 40);
            if (load[i] != 0.0) made.uniform(name(bay, level) + name(bay + 1, level), -load[i]);
        }
        if (dice.roll(0, 1) == 1.0) made.force(name(0, level), Dof::ux, dice.roll(10, 60));
    }

    Dice dice;
    FrameMaker made;
    int n_bays = 1, n_storeys = 1;
    double kind = 1.0; ///< of the loads: -1 symmetric, as Mirror::sign
};

/// Why half of it cannot be worked.
std::optional<FaultKind> symmetry_fault_of(const Model& model)
{
    try {
        static_cast<void>(by_halves(model, problem_of(model, CaseId(0))));
        return std::nullopt;
    } catch (const ModelError& error) {
        return error.faults().front().kind;
    }
}

} // namespace

TEST_CASE("One balance is exact on a symmetric beam of three spans")
{
    constexpr double l = 5, L = 8; // side spans pinned outside, the middle span
    FrameMaker made;
    made.node("A", 0, 0, pin).node("B", l, 0, roller).node("C", l + L, 0, roller).node("D", 2 * l + L, 0, roller);
    made.member("A", "B").member("B", "C").member("C", "D").uniform("AB", -q).uniform("BC", -q).uniform("CD", -q);
    const Problem problem = half_of(made.model);
    const Problem& half = problem.of_sheet(0);
    const EndId BA = *half.find_end("BA"), BC = *half.find_end("BC");
    CHECK(formula(half, BA) == "3EI/L");
    CHECK(formula(half, BC) == "2EI/L");
    CHECK(half[BC].carry_over == 0.0);
    CHECK(half[BC].factor == Approx((2 / L) / (3 / l + 2 / L)));
    const Superposition all = superpose(made.model, problem, {});
    CHECK(all.held.sheet.steps.size() == 1);
    // the three-moment equation: 2 (l + L) M + L M = q l^3 / 4 + q L^3 / 4
    const double M = q * (l * l * l + L * L * L) / (4 * (2 * l + 3 * L));
    CHECK(moment_at(problem, all.moments, "BA") == Approx(-M));
    CHECK(moment_at(problem, all.moments, "CB") == Approx(-M));
    CHECK(moment_at(problem, all.moments, "CD") == Approx(M));
}

TEST_CASE("One balance is exact on a symmetric portal, and it does not sway")
{
    const Model model = symmetric_portal().uniform("BC", -q).model;
    const Problem problem = half_of(model);
    CHECK(problem.sways.empty());
    const Superposition all = superpose(model, problem, {});
    CHECK(all.held.sheet.steps.size() == 1);
    // M_BA = q B^2 / 12 . k1 / (k1 + k2 / 2), k = I / L: the joint's share of 4EI/H against 2EI/B
    const double M = q * B * B / 12 * (4 / H) / (4 / H + 2 / B);
    CHECK(moment_at(problem, all.moments, "BA") == Approx(-M));
    CHECK(moment_at(problem, all.moments, "AB") == Approx(-M / 2));
    CHECK(moment_at(problem, all.moments, "CD") == Approx(M));
    CHECK(moment_at(problem, all.moments, "DC") == Approx(M / 2));
}

TEST_CASE("A force on a portal sways it antisymmetrically: one balance with 6EI/L, then the shear equation")
{
    const Model model = symmetric_portal().force("B", Dof::ux, W).model;
    const Problem problem = half_of(model);
    REQUIRE(problem.sways.size() == 1);
    CHECK(formula(problem.of_sheet(1), *problem.find_end("BC")) == "6EI/L");
    CHECK(problem.of_sheet(0).mirror->kind == SymmetryKind::Antisymmetric);
    const Superposition all = superpose(model, problem, {});
    CHECK(all.sways.front().sheet.steps.size() == 1);
    // k = (I_BC / B) / (I_AB / H): M_B = W H / 2 . 3k / (6k + 1), M_A = W H / 2 . (3k + 1) / (6k + 1)
    const double k = H / B;
    CHECK(moment_at(problem, all.moments, "BA") == Approx(W * H / 2 * 3 * k / (6 * k + 1)));
    CHECK(moment_at(problem, all.moments, "AB") == Approx(W * H / 2 * (3 * k + 1) / (6 * k + 1)));
    CHECK(moment_at(problem, all.moments, "CB") == Approx(moment_at(problem, all.moments, "BC")));
}

TEST_CASE("Loads of both kinds: the loads' sheet is symmetric, the sway's antisymmetric")
{
    const Model model = symmetric_portal().uniform("BC", -q).force("C", Dof::ux, W).model;
    const Problem problem = half_of(model);
    CHECK(problem.of_sheet(0).mirror->kind == SymmetryKind::Symmetric);
    CHECK(problem.of_sheet(1).mirror->kind == SymmetryKind::Antisymmetric);
    const Superposition all = superpose(model, problem, {});
    CHECK(all.held.sheet.steps.size() + all.sways.front().sheet.steps.size() == 2);
    const std::vector<double> exact = slope_deflection(model, problem_of(model, CaseId(0))).moments;
    for (std::size_t e = 0; e < exact.size(); ++e) CHECK(all.moments[e] == Approx(exact[e]));
}

TEST_CASE("A joint on the axis of a symmetric sheet is never turned")
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 5, 0, roller).node("C", 11, 0, roller).node("D", 17, 0, roller);
    made.node("E", 22, 0, fixed).member("A", "B").member("B", "C").member("D", "C").member("D", "E");
    made.uniform("AB", -9).uniform("DE", -9).uniform("BC", -4).uniform("DC", -4);
    const Problem problem = half_of(made.model);
    const std::vector<JointId> balanced = problem.of_sheet(0).balanced_joints();
    REQUIRE(balanced.size() == 1);
    CHECK(made.model[problem[balanced.front()].node].id == "B");
    for (const Order order : {Order::Largest, Order::LeftToRight, Order::AllAtOnce}) {
        const Superposition all = superpose(made.model, problem, {.order = order, .joints = {}});
        CHECK(all.held.sheet.steps.size() == 1);
        CHECK(all.rotations[problem.joint_at(NodeId(2))->index] == 0.0);
        CHECK(moment_at(problem, all.moments, "CB") == Approx(-moment_at(problem, all.moments, "CD")));
    }
}

TEST_CASE("Where all joints of a symmetric beam stand on its axis nothing is balanced")
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 5, 0, roller).node("C", 10, 0, fixed).member("A", "B").member("B", "C");
    made.uniform("AB", -q).uniform("BC", -q);
    const Problem problem = half_of(made.model);
    const Superposition all = superpose(made.model, problem, {.order = Order::AllAtOnce, .joints = {}});
    CHECK(all.held.sheet.steps.empty());
    CHECK(moment_at(problem, all.moments, "AB") == Approx(q * 25 / 12));
    CHECK(moment_at(problem, all.moments, "BA") == Approx(-q * 25 / 12));
}

TEST_CASE("A column that stands on its own axis is worked as it is")
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 0, 4).node("C", 0, 9, pin).member("A", "B").member("B", "C");
    made.force("B", Dof::rz, W);
    const Problem problem = half_of(made.model);
    const Superposition all = superpose(made.model, problem, {});
    const std::vector<double> exact = slope_deflection(made.model, problem_of(made.model, CaseId(0))).moments;
    for (std::size_t e = 0; e < exact.size(); ++e) {
        CHECK(problem.of_sheet(0).is_on_sheet(EndId(e)));
        CHECK(all.moments[e] == Approx(exact[e]));
    }
}

TEST_CASE("A joint on the axis of an antisymmetric sheet is balanced once, as it is")
{
    FrameMaker made; // two bays, pushed at the left
    made.node("A", 0, 0, fixed).node("B", 0, H).node("C", 6, 0, fixed).node("D", 6, H).node("E", 12, 0, fixed);
    made.node("F", 12, H).member("A", "B").member("C", "D").member("E", "F").member("B", "D").member("D", "F");
    made.force("B", Dof::ux, W);
    const Problem problem = half_of(made.model);
    CHECK(problem.of_sheet(1).balanced_joints().size() == 2);
    const Superposition all = superpose(made.model, problem,
                                        {.order = Order::Largest, .joints = {}, .tolerance = 1e-10});
    const std::vector<double> exact = slope_deflection(made.model, problem_of(made.model, CaseId(0))).moments;
    for (std::size_t e = 0; e < exact.size(); ++e) CHECK(all.moments[e] == Approx(exact[e]));
}

TEST_CASE("Every state that half of the joints reach is a state of the whole structure")
{
    FrameMaker made; // two storeys, so that the half is not done by one balance
    made.node("A", 0, 0, fixed).node("B", 0, 4).node("C", 0, 7).node("F", 6, 0, fixed).node("E", 6, 4).node("D", 6, 7);
    made.member("A", "B").member("B", "C").member("C", "D").member("B", "E").member("E", "D").member("F", "E");
    made.uniform("CD", -9).uniform("BE", -24);
    const Problem problem = half_of(made.model);
    CHECK(problem.sways.empty());
    for (const Order order : {Order::Largest, Order::AllAtOnce}) {
        const Sheet sheet = distribute(made.model, problem.of_sheet(0), problem.loading,
                                       {.order = order, .joints = {}, .tolerance = 1e-6});
        CHECK(sheet.steps.size() > 3);
        for (std::size_t n = 0; n <= sheet.steps.size(); ++n) {
            const State state = state_after(problem.of_sheet(0), sheet, n);
            const Results results = state_results(made.model, problem, locks_of(problem, state));
            const std::vector<double> found = end_moments(made.model, problem, results[state_case(results)]);
            for (std::size_t e = 0; e < found.size(); ++e) CHECK(std::abs(found[e] - state.moments[e]) < 1e-9);
        }
    }
}

TEST_CASE("Turn by turn the half's sheet is the same as worked through, exactly and rounded")
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 5, 0, roller).node("C", 9, 0, roller).node("D", 15, 0, roller);
    made.node("E", 19, 0, roller).node("F", 24, 0, fixed);
    made.member("A", "B").member("B", "C").member("C", "D").member("D", "E").member("E", "F");
    made.uniform("AB", -q).uniform("EF", -q).point("CD", 3, -50);
    const Problem problem = half_of(made.model);
    const Problem& half = problem.of_sheet(0);
    for (const int digits : {0, 3})
        for (const Order order : {Order::Largest, Order::LeftToRight, Order::AllAtOnce}) {
            const Procedure procedure{.order = order, .joints = {}, .tolerance = 0.5, .balances = {}, .digits = digits};
            const Sheet through = distribute(made.model, half, problem.loading, procedure);
            std::vector<Turn> turns;
            for (std::size_t n = 0; n < through.steps.size(); ++n) {
                const Sheet sheet = sheet_of(half, problem.loading, turns, procedure);
                turns.push_back(next_turn(made.model, half, sheet, procedure));
                CHECK(turns.back() == through.steps[n].joint);
            }
            const Sheet sheet = sheet_of(half, problem.loading, turns, procedure);
            CHECK(sheet.is_balanced);
            for (std::size_t e = 0; e < half.ends.size(); ++e) {
                CHECK(sheet.end.moments[e] == Approx(through.end.moments[e]));
                CHECK(sheet.end.moments[e] == -sheet.end.moments[half.mirror->ends[e].index]);
            }
            for (std::size_t j = 0; j < half.joints.size(); ++j)
                CHECK(sheet.end.rotations[j] == -sheet.end.rotations[half.mirror->joints[j].index]);
        }
}

TEST_CASE("Half of 300 random frames gives the moments of the whole, with fewer joints balanced and never more sheets")
{
    int n_one_sheet = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        const Model model = RandomFrame(seed).made.model;
        const Problem whole = problem_of(model, CaseId(0));
        const Problem problem = half_of(model, seed % 2 == 0 ? FarEnds::Modified : FarEnds::Plain);
        CHECK(problem.sways.size() <= whole.sways.size());
        n_one_sheet += problem.sways.empty() ? 1 : 0;
        for (const Problem& half : problem.halves) CHECK(half.balanced_joints().size() < half.joints.size());
        const std::vector<double> exact = slope_deflection(model, whole).moments;
        double largest = 1.0;
        for (const double moment : exact) largest = std::max(largest, std::abs(moment));
        const Superposition all = superpose(
            model, problem, {.order = static_cast<Order>(seed % 3), .joints = {}, .tolerance = 1e-10 * largest});
        for (std::size_t e = 0; e < exact.size(); ++e) CHECK(std::abs(all.moments[e] - exact[e]) < 1e-7 * largest);
    }
    CHECK(n_one_sheet > 30);
}

TEST_CASE("What keeps a structure from being halved is named")
{
    Model aside = symmetric_portal().uniform("BC", -q).model;
    aside.nodes[3].at[0] = B + 1.0;
    CHECK(symmetry_fault_of(aside) == FaultKind::CrossNodeWithoutImage);
    Model pinned = symmetric_portal().uniform("BC", -q).model;
    pinned.nodes[3].support = Support{.kind = pin};
    CHECK(symmetry_fault_of(pinned) == FaultKind::CrossEndWithoutImage);
    CHECK(symmetry_fault_of(symmetric_portal().point("BC", 2, -q).model) == FaultKind::CrossSkewLoads);
    CHECK(symmetry_fault_of(symmetric_portal().uniform("BC", -q).force("B", Dof::rz, 5).model) ==
          FaultKind::CrossSkewLoads);
    FrameMaker gable;
    gable.node("A", 0, 0, fixed).node("B", 0, 4).node("C", 4, 6).node("D", 8, 4).node("E", 8, 0, fixed);
    gable.member("A", "B").member("B", "C").member("C", "D").member("D", "E").uniform("BC", -q).uniform("CD", -q);
    CHECK(symmetry_fault_of(gable.model) == FaultKind::CrossSkewSway);
    CHECK_THROWS_AS(half_of(aside), ModelError);
    CHECK(!symmetry_fault_of(symmetric_portal().model));
}
