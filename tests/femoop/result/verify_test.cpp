#include "femoop/io/verify.h"

#include <doctest/doctest.h>

#include <string>

#include "femoop/analysis/linear_static.h"
#include "tests/femoop/result/two_cases.h"

using namespace femoop;

TEST_SUITE_BEGIN("result");

namespace {

/// One check of node A's vertical reaction in case P, which is 22.5 kN.
Model expecting(double value)
{
    Model model = two_cases();
    Expected check;
    check.quantity = ExpectedQuantity::Reaction;
    check.load_case = CaseId(0);
    check.node = NodeId(0);
    check.dof = Dof::uy;
    check.value = value;
    model.expected = {check};
    return model;
}

Verdict verdict(const Model& model) { return verify(model, analyse(model)).front().verdict; }

} // namespace

TEST_CASE("Without tolerances a check allows a millionth of its value")
{
    CHECK(verdict(expecting(22.5 * (1.0 + 0.9e-6))) == Verdict::Passed);
    CHECK(verdict(expecting(22.5 * (1.0 + 1.1e-6))) == Verdict::Failed);
    CHECK(verdict(expecting(-22.5)) == Verdict::Failed);
}

TEST_CASE("The larger of atol and rtol |value| counts")
{
    Model model = expecting(22.0);
    model.expected[0].atol = 0.51;
    CHECK(verdict(model) == Verdict::Passed);
    model.expected[0].atol = 0.49;
    CHECK(verdict(model) == Verdict::Failed);
    model.expected[0].rtol = 0.03; // 0.66
    CHECK(verdict(model) == Verdict::Passed);
}

TEST_CASE("At a load the shear is read on the + side, on the - side when asked")
{
    Model model = expecting(-7.5);
    Expected& check = model.expected[0];
    check.quantity = ExpectedQuantity::SectionForce;
    check.node.reset();
    check.dof.reset();
    check.member = MemberId(0);
    check.component = MemberComponent::Vy;
    check.at = Quantity(2.0);
    CHECK(verdict(model) == Verdict::Passed);
    check.at = Percent{25.0};
    CHECK(verdict(model) == Verdict::Passed);
    check.side = Side::Before;
    check.value = 22.5;
    CHECK(verdict(model) == Verdict::Passed);
}

TEST_CASE("At a member's end there is only the - side, also a hair beyond it")
{
    Model model = expecting(-7.5);
    Expected& check = model.expected[0];
    check.quantity = ExpectedQuantity::SectionForce;
    check.node.reset();
    check.dof.reset();
    check.member = MemberId(0);
    check.component = MemberComponent::Vy;
    check.at = Quantity(8.0 * (1.0 + 1.0e-10));
    CHECK(verdict(model) == Verdict::Passed);
}

TEST_CASE("A displacement may be one along a member")
{
    Model model = expecting(0.0);
    Expected& check = model.expected[0];
    check.quantity = ExpectedQuantity::Displacement;
    check.node.reset();
    check.dof.reset();
    check.member = MemberId(0);
    check.component = MemberComponent::v;
    check.at = Percent{50.0};
    const double a = 2.0, L = 8.0, EI = 4.0e4;
    check.value = -30.0 * a * (3.0 * L * L - 4.0 * a * a) / (48.0 * EI); // P a (3 L^2 - 4 a^2) / 48 E I at midspan
    CHECK(verdict(model) == Verdict::Passed);
}

TEST_CASE("Without a case the only load case is meant")
{
    Model model = expecting(22.5);
    model.expected[0].load_case.reset();
    model.load_cases.pop_back();
    model.combinations.clear();
    CHECK(verdict(model) == Verdict::Passed);
}

TEST_CASE("Checks of other analyses are skipped, with the reason")
{
    Model model = expecting(1.0);
    model.expected[0].analysis = ExpectedAnalysis::PDelta;
    CHECK_FALSE(needs_linear_analysis(model));
    const auto outcomes = verify(model, std::nullopt);
    REQUIRE(outcomes.size() == 1);
    CHECK(outcomes[0].skipped == SkipReason::AnalysisNotBuilt);
    CHECK(count(outcomes).skipped == 1);
    CHECK(count(outcomes).passed + count(outcomes).failed == 0);
}

TEST_SUITE_END();
