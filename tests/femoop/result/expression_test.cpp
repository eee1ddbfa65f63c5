#include <doctest/doctest.h>

#include "femoop/analysis/linear_static.h"
#include "femoop/result/expression.h"
#include "tests/frame_maker.h"

using namespace femoop;

namespace {

constexpr double L = 6.0, q = 7.0, P = 13.0, a = 2.5;

/// A simple beam with a uniform load, or with a point load at `a`.
Model beam(bool is_uniform)
{
    FrameMaker made({.id = "s", .A = 0.01, .Iz = 2e-4});
    made.node("A", 0, 0, SupportKind::Pin).node("B", L, 0, SupportKind::Roller).member("A", "B");
    return (is_uniform ? made.uniform("AB", -q) : made.point("AB", a, -P)).model;
}

std::vector<Expression> formulas(const Model& model, MemberComponent component)
{
    return expressions(analyse(model).at("P").curve(MemberId(0)), component);
}

} // namespace

TEST_SUITE("result")
{
    TEST_CASE("The moment of a simple beam under q is q L x / 2 - q x^2 / 2")
    {
        const auto M = formulas(beam(true), MemberComponent::Mz);
        REQUIRE(M.size() == 1);
        REQUIRE(M[0].coefficients.size() == 3);
        CHECK(M[0].coefficients[0] == 0.0);
        CHECK(M[0].coefficients[1] == doctest::Approx(q * L / 2));
        CHECK(M[0].coefficients[2] == doctest::Approx(-q / 2));
        CHECK(text(M[0]) == "21 x - 3.5 x²");
    }

    TEST_CASE("A coefficient 1 is not written before x, but alone it is")
    {
        CHECK(text(expression(Polynomial{2.0, -1.0}, 0.0, 4.0, 4.0)) == "2 - x");
        CHECK(text(expression(Polynomial{1.0, 0.0, 1.0}, 0.0, 4.0, 4.0)) == "1 + x²");
    }

    TEST_CASE("Under a point load there are two formulas, and where nothing changes one")
    {
        const Model model = beam(false);
        const auto M = formulas(model, MemberComponent::Mz);
        REQUIRE(M.size() == 2);
        CHECK(M[0].to == doctest::Approx(a));
        CHECK(M[1].coefficients[0] == doctest::Approx(P * a));
        CHECK(M[1].coefficients[1] == doctest::Approx(-P * a / L));
        const auto N = formulas(model, MemberComponent::N);
        REQUIRE(N.size() == 1);
        CHECK(text(N[0]) == "0");
        CHECK(N[0].to == doctest::Approx(L));
    }

    TEST_CASE("A formula gives what the curve gives, displacements too")
    {
        const Model model = beam(true);
        const Curve curve = analyse(model).at("P").curve(MemberId(0));
        for (const MemberComponent component : {MemberComponent::Vy, MemberComponent::Mz, MemberComponent::v}) {
            const Expression formula = expressions(curve, component).at(0);
            for (const double x : {0.3, 2.9, 5.6}) {
                double value = 0.0;
                for (std::size_t i = formula.coefficients.size(); i-- > 0;) value = value * x + formula.coefficients[i];
                CHECK(value == doctest::Approx(curve.value(component, x)).epsilon(1e-9));
            }
        }
    }

    TEST_CASE("On an elastic foundation the formula says that it goes on")
    {
        Model model = beam(true);
        model.members[0].foundation = 5000.0;
        const auto M = formulas(model, MemberComponent::Mz);
        CHECK(M.at(0).is_series);
        CHECK(text(M.at(0)).ends_with("…"));
    }

    TEST_CASE("From a roller on Winkler's ground M has no term in 1, x^2 and x^4: EI d4M/dx4 = -k M")
    {
        FrameMaker made({.id = "s", .A = 0.05, .Iz = 4.2e-4});
        made.node("A", 0, 0, SupportKind::Pin).node("B", 7.3, 0).member("A", "B").force("B", Dof::uy, 1.0);
        made.model.members[0].foundation = 5000.0;
        const auto M = formulas(made.model, MemberComponent::Mz);
        REQUIRE(M.size() > 1); // stretches, each with a series of its own
        for (const Expression& one : M) {
            CAPTURE(one.from);
            REQUIRE(one.coefficients.size() > 5);
            for (const std::size_t power : {0U, 2U, 4U}) CHECK(one.coefficients[power] == 0.0);
            for (const std::size_t power : {1U, 3U, 5U}) CHECK(one.coefficients[power] != 0.0);
        }
    }
}
