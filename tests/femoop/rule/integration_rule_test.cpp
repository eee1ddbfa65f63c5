#include "femoop/rule/integration_rule.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

using namespace femoop;

namespace {

struct Power {
    int xi, eta;
};

double integral_by(const IntegrationRule& rule, Power p)
{
    double sum = 0.0;
    for (const auto& [at, weight] : rule.points) sum += weight * std::pow(at.xi, p.xi) * std::pow(at.eta, p.eta);
    return sum;
}

double factorial(int n) { return std::tgamma(n + 1.0); }

/// Integral of t^n from -1 to 1.
double line_integral(int n) { return n % 2 == 0 ? 2.0 / (n + 1.0) : 0.0; }

double exact_integral(Domain domain, Power p)
{
    switch (domain) {
    case Domain::Line: return line_integral(p.xi);
    case Domain::Triangle: return factorial(p.xi) * factorial(p.eta) / factorial(p.xi + p.eta + 2);
    case Domain::Quadrilateral: break;
    }
    return line_integral(p.xi) * line_integral(p.eta);
}

bool is_up_to(Domain domain, Power p, int degree)
{
    if (domain == Domain::Line) return p.eta == 0 && p.xi <= degree;
    return domain == Domain::Triangle ? p.xi + p.eta <= degree : std::max(p.xi, p.eta) <= degree;
}

void for_every_rule(const std::function<void(const IntegrationRule&)>& check)
{
    for (const int n : {1, 2, 3, 4, 5, 7, 12}) {
        CAPTURE(n);
        check(gauss_line(n));
        check(gauss_quadrilateral(n));
        check(collapsed_triangle(n));
    }
    for (const int n : {1, 3, 6, 7}) {
        CAPTURE(n);
        check(symmetric_triangle(n));
    }
}

} // namespace

TEST_SUITE("integration rule")
{
    TEST_CASE("Every rule integrates each monomial up to its degree exactly")
    {
        for_every_rule([](const IntegrationRule& rule) {
            for (int i = 0; i <= rule.degree; ++i)
                for (int j = 0; j <= rule.degree; ++j) {
                    if (!is_up_to(rule.domain, {i, j}, rule.degree)) continue;
                    CAPTURE(i);
                    CAPTURE(j);
                    CHECK(std::abs(integral_by(rule, {i, j}) - exact_integral(rule.domain, {i, j})) <= 5e-15);
                }
        });
    }

    TEST_CASE("No rule does better than its degree says")
    {
        for_every_rule([](const IntegrationRule& rule) {
            if (rule.degree > 15) return; // what they miss there is less than rounding
            double worst = 0.0;
            for (int i = 0; i <= rule.degree + 1; ++i)
                for (int j = 0; j <= rule.degree + 1; ++j) {
                    if (!is_up_to(rule.domain, {i, j}, rule.degree + 1)) continue;
                    const double exact = exact_integral(rule.domain, {i, j});
                    worst = std::max(worst, std::abs(integral_by(rule, {i, j}) - exact));
                }
            CAPTURE(rule.degree);
            CHECK(worst > 1e-14);
        });
    }

    TEST_CASE("Weights are positive and add up to the domain's measure")
    {
        for_every_rule([](const IntegrationRule& rule) {
            for (const IntegrationPoint& point : rule.points) CHECK(point.weight > 0.0);
            CHECK(integral_by(rule, {0, 0}) == doctest::Approx(measure(rule.domain)).epsilon(2e-15));
        });
    }

    TEST_CASE("Points lie inside the domain")
    {
        for_every_rule([](const IntegrationRule& rule) {
            for (const auto& [at, weight] : rule.points) {
                if (rule.domain == Domain::Triangle) {
                    CHECK(std::min(at.xi, at.eta) > 0.0);
                    CHECK(at.xi + at.eta < 1.0);
                } else CHECK(std::max(std::abs(at.xi), std::abs(at.eta)) < 1.0);
            }
        });
    }

    TEST_CASE("Gauss's points lie at 1/sqrt(3), and at 0 and sqrt(3/5) with weights 8/9 and 5/9")
    {
        CHECK(gauss_line(2).points[1].at.xi == doctest::Approx(1.0 / std::sqrt(3.0)).epsilon(1e-15));
        const IntegrationRule three = gauss_line(3);
        CHECK(three.points[0].at.xi == doctest::Approx(-std::sqrt(0.6)).epsilon(1e-15));
        CHECK(three.points[0].weight == doctest::Approx(5.0 / 9.0).epsilon(1e-15));
        CHECK(three.points[1].at.xi == 0.0);
        CHECK(three.points[1].weight == doctest::Approx(8.0 / 9.0).epsilon(1e-15));
    }

    TEST_CASE("A rule that is asked for by its degree has it")
    {
        for (const Domain domain : {Domain::Line, Domain::Triangle, Domain::Quadrilateral})
            for (int degree = 0; degree <= 12; ++degree) {
                const IntegrationRule rule = rule_of_degree(domain, degree);
                CHECK(rule.domain == domain);
                CHECK(rule.degree >= degree);
                CHECK(rule.degree <= degree + 1);
            }
    }

    TEST_CASE("A triangle has no symmetric rule of four points here")
    {
        CHECK_THROWS_AS(symmetric_triangle(4), std::invalid_argument);
    }
}
