// A thousand random beams and frames against the analysis.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/cross/comparison.h"
#include "femoop/methods/cross/kani.h"
#include "femoop/methods/cross/slope_deflection.h"
#include "femoop/methods/cross/state_model.h"
#include "femoop/methods/cross/superposition.h"
#include "tests/femoop/methods/cross/random_frame.h"

using namespace femoop;
using namespace femoop::cross;

namespace {

double largest(const std::vector<double>& values)
{
    double most = 0.0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
}

double difference(const std::vector<double>& a, const std::vector<double>& b)
{
    REQUIRE(a.size() == b.size());
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        REQUIRE(std::isfinite(a[i]));
        most = std::max(most, std::abs(a[i] - b[i]));
    }
    return most;
}

std::vector<double> exact(const Model& model, const Problem& problem)
{
    return end_moments(model, problem, analyse(inextensible_copy(model))[CaseId(0)]);
}

constexpr FarEnds every_way[] = {FarEnds::Modified, FarEnds::ReleasedOnSheet, FarEnds::Plain};
constexpr Order every_order[] = {Order::Largest, Order::LeftToRight, Order::AllAtOnce, Order::Listed};

struct Cycles {
    int n_tried = 0, n_ended = 0;
};

/// Distributes to a tolerance and compares with the analysis, of some also Kani's cycles.
void check_final(const Model& model, unsigned seed, Cycles& by_cycles)
{
    const FarEnds far_ends = every_way[seed % 3];
    CAPTURE(static_cast<int>(far_ends));
    const Problem problem = problem_of(model, CaseId(0), far_ends);
    const std::vector<double> wanted = exact(model, problem);
    const double scale = std::max(1.0, largest(wanted));
    CHECK(difference(slope_deflection(model, problem).moments, wanted) < 1e-7 * scale);
    const Procedure procedure{.order = every_order[seed % 4], .joints = {}, .tolerance = 1e-9 * scale, .balances = {}};
    const Superposition all = superpose(model, problem, procedure);
    CHECK(difference(all.moments, wanted) < 1e-6 * scale);
    if (seed % 5 != 0) return;
    const Kani rotations = kani(model, problem);
    ++by_cycles.n_tried;
    if (!rotations.is_converged) return;
    ++by_cycles.n_ended;
    CHECK(difference(rotations.moments, wanted) < 1e-5 * scale);
}

/// A state of the sheet is what the analysis finds with its joints clamped as they are.
void check_states(const Model& model, unsigned seed)
{
    const Problem problem = problem_of(model, CaseId(0), every_way[seed % 3]);
    const Sheet sheet = distribute(model, problem, problem.loading, {.order = every_order[seed % 4], .joints = {}});
    for (std::size_t n = 0; n <= std::min<std::size_t>(sheet.steps.size(), 3); ++n) {
        const State state = state_after(problem, sheet, n);
        CAPTURE(n);
        const Results results = state_results(model, problem, locks_of(problem, state));
        const CaseResult result = results[state_case(results)];
        CHECK(difference(end_moments(model, problem, result), state.moments) < 1e-7 * (1.0 + largest(state.moments)));
        CHECK(result.equilibrium().residual < 1e-6);
    }
}

} // namespace

TEST_CASE("Distributed moments of 500 random beams are those of the analysis")
{
    Cycles by_cycles;
    for (unsigned seed = 0; seed < 500; ++seed) {
        CAPTURE(seed);
        check_final(random_beam(seed), seed, by_cycles);
    }
    CHECK(by_cycles.n_ended == by_cycles.n_tried);
}

TEST_CASE("Distributed moments of 500 random frames that sway are those of the analysis")
{
    Cycles by_cycles; // of which a few frames in a hundred need more than are made
    int n_swaying = 0;
    for (unsigned seed = 0; seed < 500; ++seed) {
        CAPTURE(seed);
        const Model model = random_frame(seed);
        check_final(model, seed, by_cycles);
        n_swaying += problem_of(model, CaseId(0)).sways.empty() ? 0 : 1;
    }
    CHECK(n_swaying > 400);
    CHECK(20 * by_cycles.n_ended > 19 * by_cycles.n_tried);
}

TEST_CASE("Each state of a random sheet is a real structure in equilibrium")
{
    for (unsigned seed = 0; seed < 120; ++seed) {
        CAPTURE(seed);
        check_states(random_beam(seed), seed);
        check_states(random_frame(seed), seed);
    }
}
