#include <doctest/doctest.h>

#include "femoop/methods/cross/slope_deflection.h"
#include "femoop/methods/cross/symmetry.h"
#include "tests/femoop/methods/cross/frames.h"

using namespace femoop;
using namespace femoop::cross;
using doctest::Approx;

namespace {

FrameMaker portal()
{
    FrameMaker made;
    made.node("A", 0, 0, fixed).node("B", 0, 4).node("C", 7, 4).node("D", 7, 0, fixed);
    made.member("A", "B").member("B", "C").member("D", "C");
    return made;
}

/// Half of the joints give what all of them give.
void check_half(const Model& model, const Problem& problem, const Loading& loading, SymmetryKind kind)
{
    const auto symmetry = symmetry_of(model, problem, loading);
    REQUIRE(symmetry);
    CHECK(symmetry->kind == kind);
    const Half half = half_of(problem, loading, *symmetry);
    CHECK(2 * half.problem.joints.size() <= problem.joints.size());
    const Procedure procedure{.order = Order::Largest, .joints = {}, .tolerance = 1e-11, .balances = {}};
    const Sheet part = distribute(model, half.problem, half.loading, procedure);
    const Sheet all = distribute(model, problem, loading, procedure);
    const std::vector<double> whole = whole_of(*symmetry, half.problem, part.end.moments);
    for (std::size_t e = 0; e < whole.size(); ++e) CHECK(whole[e] == Approx(all.end.moments[e]).epsilon(1e-9));
}

} // namespace

TEST_CASE("A symmetric load offers 2EI/L for the beam across the axis, one release does")
{
    const Model model = portal().uniform("BC", -12).model;
    const Problem problem = problem_of(model, CaseId(0));
    check_half(model, problem, problem.loading, SymmetryKind::Symmetric);
    const Half half = half_of(problem, problem.loading, *symmetry_of(model, problem, problem.loading));
    CHECK(formula(half.problem, *problem.find_end("BC")) == "2EI/L");
    CHECK(half.problem[*problem.find_end("BC")].carry_over == 0.0);
}

TEST_CASE("Its sway is antisymmetric and offers 6EI/L")
{
    const Model model = portal().uniform("BC", -12).model;
    const Problem problem = problem_of(model, CaseId(0));
    const Loading& sway = problem.sways.front().loading;
    check_half(model, problem, sway, SymmetryKind::Antisymmetric);
    const Half half = half_of(problem, sway, *symmetry_of(model, problem, sway));
    CHECK(formula(half.problem, *problem.find_end("BC")) == "6EI/L");
}

TEST_CASE("Joints on the axis of a symmetric beam do not turn")
{
    FrameMaker made;
    made.node("A", 0, 0, pin).node("B", 5, 0, roller).node("C", 11, 0, roller).node("D", 17, 0, roller);
    made.node("E", 22, 0, roller).member("A", "B").member("B", "C").member("D", "C").member("D", "E");
    made.uniform("AB", -9).uniform("DE", -9).uniform("BC", -4).uniform("DC", -4);
    const Problem problem = problem_of(made.model, CaseId(0));
    check_half(made.model, problem, problem.loading, SymmetryKind::Symmetric);
}

TEST_CASE("No shortcut is offered where the load or the structure is skew")
{
    const Model skew_load = portal().point("BC", 2, -12).model;
    const Problem loaded = problem_of(skew_load, CaseId(0));
    CHECK(!symmetry_of(skew_load, loaded, loaded.loading));
    Model skew_structure = portal().uniform("BC", -12).model;
    skew_structure.nodes[3].support = Support{.kind = pin};
    const Problem skew = problem_of(skew_structure, CaseId(0));
    CHECK(!symmetry_of(skew_structure, skew, skew.loading));
}
