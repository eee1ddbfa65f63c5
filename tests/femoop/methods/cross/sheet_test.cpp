#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/cross/comparison.h"
#include "femoop/methods/cross/fraction.h"
#include "femoop/methods/cross/kani.h"
#include "femoop/methods/cross/rounding.h"
#include "femoop/methods/cross/slope_deflection.h"
#include "femoop/methods/cross/state_model.h"
#include "femoop/methods/cross/superposition.h"
#include "femoop/methods/cross/virtual_work.h"
#include "tests/femoop/analysis/random_structure.h"
#include "tests/femoop/methods/cross/frames.h"

using namespace femoop;
using namespace femoop::cross;
using doctest::Approx;

namespace {

/// Four spans with an overhang: A pinned, E with 2 m beyond it.
Model beam()
{
    FrameMaker made;
    made.node("A", 0, 0, pin).node("B", 6, 0, roller).node("C", 13, 0, roller).node("D", 18, 0, roller);
    made.node("E", 20.5, 0).member("A", "B").member("B", "C").member("C", "D").member("D", "E");
    made.uniform("AB", -12).point("BC", 3, -50).uniform("CD", -20).uniform("DE", -8).force("C", Dof::rz, 15);
    return made.model;
}

/// A portal 5 m wide and high with 16 kN at 1 m from its left corner, as in R. C. Hibbeler, Structural Analysis,
/// ch. 12.
Model portal()
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 0, 5).node("C", 5, 5).node("D", 5, 0, fixed);
    made.member("A", "B").member("B", "C").member("C", "D").point("BC", 1, -16);
    return made.model;
}

double at(const Problem& problem, const std::vector<double>& moments, std::string_view label)
{
    return moments[problem.find_end(label).value().index];
}

const End& end(const Problem& problem, std::string_view label) { return problem[problem.find_end(label).value()]; }

constexpr double EI = 20000.0;

} // namespace

/// A fixed, B on a roller, C fixed; both spans are 90 cm deep at the walls and 45 cm over B.
Model haunches()
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 4, 0, roller).node("C", 9, 0, fixed);
    made.member("A", "B").member("B", "C").uniform("AB", -20).point("BC", 2, -50);
    SectionShape rectangle;
    rectangle.b = 0.3;
    rectangle.h = 0.9;
    made.model.sections[0] = Section{.id = "haunch", .shape = rectangle};
    made.model.members[0].depths = {0.9, 0.45};
    made.model.members[1].depths = {0.45, 0.9};
    return made.model;
}

TEST_CASE("Stiffness and carry-over of a tapered member are its own, and the sheet ends at the exact moments")
{
    const Problem problem = problem_of(haunches(), CaseId(0));
    CHECK(end(problem, "BA").carry_over > 0.8); // towards the deep end
    CHECK(formula(problem, *problem.find_end("BA")).empty());
    const Comparison comparison = compare(haunches(), problem, slope_deflection(haunches(), problem).moments);
    for (std::size_t e = 0; e < problem.ends.size(); ++e)
        CHECK(comparison.limit[e] == Approx(comparison.stiffness[e]).epsilon(1e-9));
}

TEST_CASE("Ends towards a pin or an overhang take 3EI/L, the overhang itself takes nothing")
{
    const Problem problem = problem_of(beam(), CaseId(0));
    CHECK(end(problem, "BA").stiffness == Approx(3.0 * EI / 6.0));
    CHECK(end(problem, "BC").stiffness == Approx(4.0 * EI / 7.0));
    CHECK(end(problem, "CD").stiffness == Approx(3.0 * EI / 5.0));
    CHECK(end(problem, "DE").stiffness == 0.0);
    CHECK(end(problem, "CD").carry_over == 0.0);
    CHECK(end(problem, "BC").carry_over == Approx(0.5));
    CHECK(end(problem, "BA").factor + end(problem, "BC").factor == Approx(1.0));
    CHECK(formula(problem, *problem.find_end("CD")) == "3EI/L");
    const double overhang = 8.0 * 2.5 * 2.5 / 2.0;
    CHECK(at(problem, problem.loading.fixed_end, "DE") == Approx(overhang));
    CHECK(at(problem, problem.loading.fixed_end, "DC") == Approx(-overhang));
    CHECK(at(problem, problem.loading.fixed_end, "CD") == Approx(20.0 * 25.0 / 8.0 - overhang / 2.0));
    CHECK(at(problem, problem.loading.fixed_end, "BA") == Approx(-12.0 * 36.0 / 8.0));
    CHECK(problem.joints.size() == 2);
}

TEST_CASE("Every order and every way with far ends tends to the same moments, those of the analysis")
{
    const Model model = beam();
    for (const FarEnds far_ends : {FarEnds::Modified, FarEnds::ReleasedOnSheet, FarEnds::Plain})
        for (const Order order : {Order::Largest, Order::LeftToRight, Order::AllAtOnce, Order::Listed}) {
            const Problem problem = problem_of(model, CaseId(0), far_ends);
            const Procedure procedure{.order = order, .joints = {}, .tolerance = 1e-10, .balances = {}};
            const Comparison all = compare(model, problem, superpose(model, problem, procedure).moments);
            for (const double difference : all.difference) CHECK(difference < 1e-9);
        }
}

TEST_CASE("Released on the sheet a hinged end is balanced once and gets nothing any more")
{
    const Model model = beam();
    const Problem problem = problem_of(model, CaseId(0), FarEnds::ReleasedOnSheet);
    const Sheet sheet = distribute(model, problem, problem.loading, {.order = Order::AllAtOnce, .joints = {}});
    CHECK(at(problem, sheet.start.moments, "AB") == Approx(12.0 * 36.0 / 12.0));
    const std::vector<Row> rows = rows_of(problem, sheet);
    CHECK(at(problem, rows[1].values, "AB") == Approx(-36.0));
    CHECK(at(problem, rows[2].values, "BA") == Approx(-18.0));
    for (std::size_t i = 2; i + 1 < rows.size(); ++i) CHECK(at(problem, rows[i].values, "AB") == 0.0);
}

TEST_CASE("A sheet stops when no unbalance is larger than the tolerance, and not before")
{
    const Model model = beam();
    const Problem problem = problem_of(model, CaseId(0), FarEnds::Plain);
    const Procedure procedure{.order = Order::Largest, .joints = {}, .tolerance = 0.05, .balances = {}};
    const Sheet sheet = distribute(model, problem, problem.loading, procedure);
    CHECK(sheet.is_balanced);
    const std::vector<double> history = convergence(sheet);
    CHECK(history.back() <= 0.05);
    CHECK(*std::min_element(history.begin(), history.end() - 1) > 0.05);
    CHECK(rate(problem, sheet).value() < 0.6);
}

TEST_CASE("Clicking joints one after another is the sheet of that order")
{
    const Model model = beam();
    const Problem problem = problem_of(model, CaseId(0), FarEnds::Plain);
    const Sheet sheet = distribute(model, problem, problem.loading, {.order = Order::Largest, .joints = {}});
    State state = locked_state(problem, problem.loading);
    for (std::size_t n = 0; n < sheet.steps.size(); ++n) {
        REQUIRE(sheet.steps[n].joint == worst_joint(problem, state));
        const Release release = release_of(problem, state, *sheet.steps[n].joint);
        CHECK(release.balance.size() == sheet.balanced(sheet.steps[n]).size());
        CHECK(release.carry_over.size() == sheet.carried_over(sheet.steps[n]).size());
        state = balance(problem, state, *sheet.steps[n].joint);
        const State replayed = state_after(problem, sheet, n + 1);
        for (std::size_t e = 0; e < state.moments.size(); ++e) {
            CHECK(state.moments[e] == Approx(replayed.moments[e]));
            if (n + 1 == sheet.steps.size()) CHECK(state.moments[e] == Approx(sheet.end.moments[e]));
        }
    }
}

TEST_CASE("On paper every number has its digits, and the drift is what they cost")
{
    const Model model = beam();
    const Problem problem = problem_of(model, CaseId(0));
    const Procedure on_paper{.order = Order::AllAtOnce, .joints = {}, .tolerance = {}, .balances = 4, .digits = 3};
    Procedure exactly = on_paper;
    exactly.digits = 0;
    const Sheet rough = distribute(model, problem, problem.loading, on_paper);
    const Sheet exact = distribute(model, problem, problem.loading, exactly);
    for (const Change& change : rough.changes) CHECK(change.value == rounded(change.value, 3));
    const std::vector<double> cost = drift(problem, problem.loading, rough);
    double largest = 0.0;
    for (std::size_t e = 0; e < cost.size(); ++e) {
        CHECK(cost[e] == Approx(rough.end.moments[e] - exact.end.moments[e]).epsilon(1e-9));
        largest = std::max(largest, std::abs(cost[e]));
    }
    CHECK(largest > 1e-3);
    CHECK(largest < 1.0);
    CHECK(rounded(-0.0123456, 3) == -0.0123);
    CHECK(rounded(0.0, 3) == 0.0);
}

TEST_CASE("A sheet that its steps cannot balance names the worst joint")
{
    const Model model = beam();
    const Problem problem = problem_of(model, CaseId(0));
    Procedure procedure{.order = Order::Listed, .joints = {JointId(0)}, .tolerance = 1e-3, .balances = {}};
    CHECK_THROWS_WITH_AS(distribute(model, problem, problem.loading, procedure),
                         doctest::Contains("after 20000 steps joint C still has an unbalance of"), ModelError);
    procedure.most_steps = 3;
    CHECK(try_to_distribute(model, problem, problem.loading, procedure).steps.size() == 3);
}

TEST_CASE("Factors are told as fractions where they are simple")
{
    CHECK(fraction_text(fraction_of(3.0 / 7.0).value()) == "3/7");
    CHECK(fraction_text(fraction_of(1.0).value()) == "1");
    CHECK(fraction_text(fraction_of(0.0).value()) == "0");
    CHECK(fraction_text(fraction_of(-2.0 / 3.0).value()) == "-2/3");
    CHECK(!fraction_of(std::sqrt(0.5)));
    CHECK(!fraction_of(std::nan("")));
    CHECK(!fraction_of(std::numeric_limits<double>::infinity()));
}

// With EI/L = k everywhere and F = Pab2/L2, G = Pa2b/L2 at the beam's ends, slope-deflection gives for the joints
//     8 k B + 2 k C - 6 k s = -F,   2 k B + 8 k C - 6 k s = G,   s = (B + C)/4 (shear of the columns) or 0 (propped)
// so that (B + C) k = (G - F)/7, propped (G - F)/10, and (B - C) k = -(F + G)/6.
TEST_CASE("A square portal: the prop holds 3 (F - G)/5L, the sway 280/L, and the columns' ends are exact")
{
    const Model model = portal();
    const Problem problem = problem_of(model, CaseId(0));
    REQUIRE(problem.sways.size() == 1);
    const Procedure procedure{.order = Order::AllAtOnce, .joints = {}, .tolerance = 1e-9, .balances = {}};
    const Superposition all = superpose(model, problem, procedure);
    constexpr double P = 16.0, L = 5.0, a = 1.0, b = 4.0, F = P * a * b * b / (L * L), G = P * a * a * b / (L * L);
    CHECK(std::abs(all.held.holding[0]) == Approx(3.0 * (F - G) / (5.0 * L)));
    // of 100 at every column end: both corners turn by 10 / k, which takes 20 from the foot and 40 from the head
    CHECK(at(problem, all.sways[0].sheet.end.moments, "AB") == Approx(80.0));
    CHECK(at(problem, all.sways[0].sheet.end.moments, "BA") == Approx(60.0));
    CHECK(all.R(0, 0) == Approx(280.0 / L));
    constexpr double sum = (G - F) / 7.0, difference = -(F + G) / 6.0, sway = 6.0 * sum / 4.0;
    constexpr double B = (sum + difference) / 2.0, C = (sum - difference) / 2.0;
    const std::pair<const char*, double> exact[] = {
        {"AB", 2.0 * B - sway}, {"BA", 4.0 * B - sway}, {"CD", 4.0 * C - sway}, {"DC", 2.0 * C - sway}};
    for (const auto& [label, value] : exact) CHECK(at(problem, all.moments, label) == Approx(value));
}

namespace {

/// A portal whose loads are symmetric but for a force at B.
FrameMaker symmetric_portal(double force)
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 0, 4).node("C", 6, 4).node("D", 6, 0, fixed);
    made.member("A", "B").member("B", "C").member("C", "D").uniform("BC", -30);
    if (force != 0.0) made.force("B", Dof::ux, force);
    return made;
}

} // namespace

TEST_CASE("What the tolerance leaves of a symmetric portal's prop force is 0, and so is its sway")
{
    const FrameMaker made = symmetric_portal(0.0);
    const Problem problem = problem_of(made.model, CaseId(0));
    for (const Order order : {Order::Largest, Order::LeftToRight}) {
        const Superposition all = superpose(made.model, problem, {.order = order, .joints = {}});
        const Moments moments{all.held.sheet.end.moments, all.held.sheet.end.rotations};
        REQUIRE(holding_forces(problem, moments)[0] != 0.0);
        CHECK(all.held.holding[0] == 0.0);
        CHECK(all.x[0] == 0.0);
        CHECK(all.displacements[0] == 0.0);
        CHECK(all.R(0, 0) > 0.0);
    }
}

TEST_CASE("A force on the prop stays, however small, and so does that of a sheet that is not balanced yet")
{
    const FrameMaker skew = symmetric_portal(1e-4), made = symmetric_portal(0.0);
    const Superposition all = superpose(skew.model, problem_of(skew.model, CaseId(0)), {});
    CHECK(all.held.holding[0] != 0.0);
    CHECK(all.x[0] != 0.0);
    const Superposition begun = superpose(made.model, problem_of(made.model, CaseId(0)), {.joints = {}, .balances = 1});
    CHECK(begun.held.holding[0] != 0.0);
}

TEST_CASE("In every sheet of a frame the analysis finds the same prop forces, reactions included")
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 0, 4).node("C", 3, 6).node("D", 6, 4).node("E", 6, 0, pin);
    made.member("A", "B").member("B", "C").member("C", "D").member("D", "E");
    made.uniform("BC", -10).force("B", Dof::ux, 7);
    const Problem problem = problem_of(made.model, CaseId(0));
    REQUIRE(problem.sways.size() == 2); // a gable spreads and sways
    const Superposition all = superpose(made.model, problem, {.order = Order::Largest, .joints = {}});
    const auto check = [&](const Locks& locks, const std::vector<double>& holding) {
        const Results results = state_results(made.model, problem, locks);
        for (std::size_t s = 0; s < problem.sways.size(); ++s) {
            const NodeVector reaction = results[state_case(results)].reaction(problem.sways[s].prop);
            const Eigen::Vector2d force(reaction[0], reaction[1]);
            CHECK(force.dot(problem.sways[s].direction) == Approx(holding[s]).epsilon(1e-6));
        }
    };
    check(locks_of(problem, all.held.sheet.end), all.held.holding);
    for (std::size_t k = 0; k < 2; ++k) check(locks_of(problem, all.sways[k].sheet.end, k), all.sways[k].holding);
    check(locks_of(problem, all), {0.0, 0.0});
}

TEST_CASE("Equations that are factored once give the same states as those made anew for each")
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 0, 4).node("C", 6, 4).node("D", 6, 0, pin);
    made.member("A", "B").member("B", "C").member("C", "D");
    made.uniform("BC", -10).force("B", Dof::ux, 7);
    for (const FarEnds ends : {FarEnds::Modified, FarEnds::ReleasedOnSheet}) {
        const Problem problem = problem_of(made.model, CaseId(0), ends);
        const Superposition all = superpose(made.model, problem, {.order = Order::Largest, .joints = {}});
        StateAnalysis analysis(made.model, problem);
        for (const Locks& locks : {locks_of(problem, all.held.sheet.start), locks_of(problem, all.held.sheet.end),
                                   locks_of(problem, all.sways[0].sheet.end, 0), locks_of(problem, all)}) {
            const Results once = analysis.solve(made.model, problem, locks),
                          anew = state_results(made.model, problem, locks);
            for (std::size_t n = 0; n < 4; ++n) {
                const NodeVector a = once[state_case(once)].displacement(NodeId(n)),
                                 b = anew[state_case(anew)].displacement(NodeId(n));
                for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == Approx(b[i]).epsilon(1e-9));
            }
        }
    }
}

TEST_CASE("A sway lengthens no member, and every sway moves its own prop by 1")
{
    FrameMaker made;
    for (const char* level : {"1", "2", "3"}) {
        const double y = 3.0 * (level[0] - '1');
        const auto support = level[0] == '1' ? std::optional(fixed) : std::nullopt;
        made.node(std::string("L") + level, 0.2 * y, y, support).node(std::string("R") + level, 6, y, support);
    }
    made.member("L1", "L2").member("L2", "L3").member("R1", "R2").member("R2", "R3");
    made.member("L2", "R2").member("L3", "R3").uniform("L2R2", -10);
    const Problem problem = problem_of(made.model, CaseId(0));
    REQUIRE(problem.sways.size() == 2);
    for (const Sway& sway : problem.sways) {
        CHECK(sway.displacement[sway.prop.index].dot(sway.direction) == Approx(1.0));
        for (const MemberAction& action : problem.members) {
            const Eigen::Vector2d apart = sway.displacement[action.nodes[1].index] -
                                          sway.displacement[action.nodes[0].index];
            CHECK(std::abs(apart.dot(action.x)) < 1e-12);
        }
    }
}

TEST_CASE("Shear strain enters the stiffness and the carry-over: (4 + f) / (1 + f) and (2 - f) / (4 + f)")
{
    Model model = beam();
    model.members[1].theory = BeamTheory::Timoshenko;
    const Problem problem = problem_of(model, CaseId(0), FarEnds::Plain);
    const double G = 2e8 / 2.6, f = 12.0 * EI / (G * 0.004 * 49.0);
    CHECK(end(problem, "BC").stiffness == Approx((4.0 + f) / (1.0 + f) * EI / 7.0));
    CHECK(end(problem, "BC").carry_over == Approx((2.0 - f) / (4.0 + f)));
    CHECK(formula(problem, *problem.find_end("BC")).empty());
}

TEST_CASE("Ends that would be called the same are told apart")
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("AB", 4, 0, roller).node("B", 8, 0, fixed).member("A", "AB").member("AB", "B");
    made.member("A", "AB").model.members[2].id = "twin";
    const Problem problem = problem_of(made.model, CaseId(0));
    CHECK(problem.find_end("AB-B"));
    CHECK(problem.find_end("A-AB (twin)"));
    CHECK(!problem.find_end("AAB"));
}

TEST_CASE("Kani's rotation factors are minus half the distribution factors, and its moments those of the sheet")
{
    const Model model = portal();
    const Problem problem = problem_of(model, CaseId(0));
    const Kani method = kani(model, problem);
    CHECK(method.is_converged);
    CHECK(at(problem, method.rotation_factor, "BA") == Approx(-0.25));
    const Superposition all = superpose(model, problem,
                                        {.order = Order::Largest, .joints = {}, .tolerance = 1e-9, .balances = {}});
    for (std::size_t e = 0; e < all.moments.size(); ++e)
        CHECK(method.moments[e] == Approx(all.moments[e]).epsilon(1e-6));
}

TEST_CASE("A moment on a joint that nothing holds is refused, and so is a mechanism")
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 4, 0, roller).node("C", 8, 0, fixed).member("A", "B").member("B", "C");
    made.model.nodes[1].hinge = true;
    CHECK(problem_of(made.model, CaseId(0)).joints.empty());
    made.force("B", Dof::rz, 5);
    CHECK_THROWS_WITH_AS(problem_of(made.model, CaseId(0)), doctest::Contains("joint B has no stiffness"), ModelError);

    Model swaying = portal();
    for (const std::size_t foot : {0U, 3U}) swaying.nodes[foot].support = Support{.kind = pin};
    for (const std::size_t top : {1U, 2U}) swaying.nodes[top].hinge = true;
    const Problem problem = problem_of(swaying, CaseId(0));
    CHECK_THROWS_AS(superpose(swaying, problem, {}), ModelError);
}

TEST_CASE("Whatever a random plane structure has, it is distributed or refused, never without numbers")
{
    int n_worked = 0;
    for (unsigned seed = 0; seed < 150; ++seed) {
        CAPTURE(seed);
        Model model = random_structure(AnalysisKind::Frame2d, seed);
        if (seed % 2 == 0)
            for (Member& member : model.members) member.start.offset.clear();
        if (seed % 4 == 0)
            for (LoadCase& load_case : model.load_cases) {
                load_case.settlements.clear(); // what axially rigid members could not follow
                std::erase_if(load_case.members, [](const MemberLoad& load) {
                    return std::holds_alternative<TemperatureLoad>(load.load) ||
                           std::holds_alternative<Misfit>(load.load);
                });
            }
        try {
            const Problem problem = problem_of(model, CaseId(0));
            const Superposition all = superpose(model, problem, {.order = Order::AllAtOnce, .joints = {}});
            for (const double moment : all.moments) CHECK(std::isfinite(moment));
            ++n_worked;
        } catch (const ModelError& error) {
            CHECK(!error.faults().empty());
        }
    }
    CHECK(n_worked > 10);
}
