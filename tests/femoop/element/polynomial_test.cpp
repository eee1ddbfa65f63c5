#include <doctest/doctest.h>
#include <numbers>
#include <stdexcept>

#include "femoop/element/polynomial.h"

using femoop::Polynomial;

TEST_SUITE("polynomial")
{
    TEST_CASE("The roots of (t - 0.3)(t - 1.7)(t - 2.9) in [0, 2] are 0.3 and 1.7")
    {
        const Polynomial p{-1.479, 6.31, -4.9, 1.0};
        const std::vector<double> roots = p.roots(2.0);
        REQUIRE(roots.size() == 2);
        CHECK(roots[0] == doctest::Approx(0.3).epsilon(1e-13));
        CHECK(roots[1] == doctest::Approx(1.7).epsilon(1e-13));
    }

    TEST_CASE("A parabola that touches zero has one root, where it touches")
    {
        const Polynomial p{0.49, -1.4, 1.0}; // (t - 0.7)^2
        const std::vector<double> roots = p.roots(3.0);
        REQUIRE(roots.size() == 1);
        CHECK(roots[0] == doctest::Approx(0.7).epsilon(1e-7));
    }

    TEST_CASE("Roots at the ends of the interval count")
    {
        const Polynomial p{0.0, 2.5, -1.0}; // t (2.5 - t)
        const std::vector<double> roots = p.roots(2.5);
        REQUIRE(roots.size() == 2);
        CHECK(roots[0] == 0.0);
        CHECK(roots[1] == doctest::Approx(2.5));
    }

    TEST_CASE("A polynomial without sign change and a constant have no roots")
    {
        CHECK(Polynomial{1.0, 0.0, 3.0}.roots(5.0).empty());
        CHECK(Polynomial{4.0}.roots(5.0).empty());
        CHECK(Polynomial{0.0, 0.0}.roots(5.0).empty());
        CHECK(Polynomial{}.roots(5.0).empty());
    }

    TEST_CASE("A power series of the cosine has the roots of the cosine")
    {
        Polynomial cosine;
        double term = 1.0;
        for (std::size_t i = 0; i < Polynomial::max_terms; ++i) {
            cosine.append(i % 2 == 0 ? term : 0.0);
            if (i % 2 == 0) term *= -1.0 / (static_cast<double>(i + 1) * static_cast<double>(i + 2));
        }
        const std::vector<double> roots = cosine.roots(3.0);
        REQUIRE(roots.size() == 1);
        CHECK(roots[0] == doctest::Approx(std::numbers::pi / 2.0).epsilon(1e-12));
    }

    TEST_CASE("The derivative of 7 + 5 t - 2 t^3 is 5 - 6 t^2")
    {
        const Polynomial d = Polynomial{7.0, 5.0, 0.0, -2.0}.derivative();
        CHECK(d.n_terms() == 3);
        CHECK(d[0] == 5.0);
        CHECK(d[1] == 0.0);
        CHECK(d[2] == -6.0);
    }

    TEST_CASE("Shifted, a polynomial has the values that it has further on")
    {
        const Polynomial p{7.0, 5.0, 0.0, -2.0};
        const Polynomial shifted = p.shifted(1.3);
        for (const double t : {-0.7, 0.0, 2.9}) CHECK(shifted(t) == doctest::Approx(p(t + 1.3)));
    }

    TEST_CASE("A polynomial times its reciprocal is 1 within a sixth of the way to its nearest zero")
    {
        const Polynomial p{6.0, -5.0, 1.0}; // (2 - t)(3 - t)
        for (const double t : {-1.0 / 3.0, 0.0, 0.1, 1.0 / 3.0})
            CHECK(std::abs(p(t) * p.reciprocal()(t) - 1.0) <= 1e-15);
    }

    TEST_CASE("The second moment of 5 - 2 t over [0, 3] is 5 3^3 / 3 - 2 3^4 / 4")
    {
        CHECK(Polynomial{5.0, -2.0}.moment(2, 3.0) == doctest::Approx(5.0 * 9.0 - 81.0 / 2.0));
        CHECK(Polynomial{5.0, -2.0}.moment(0, 3.0) == doctest::Approx(15.0 - 9.0));
    }

    TEST_CASE("A polynomial refuses more terms than it has room for")
    {
        Polynomial p;
        for (std::size_t i = 0; i < Polynomial::max_terms; ++i) p.append(1.0);
        CHECK_THROWS_AS(p.append(1.0), std::length_error);
    }
}
