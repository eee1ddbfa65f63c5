#include "apps/frame/predict/guess.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using frame::Guess;
using frame::StrokePoint;

namespace {

Guess drawn(const std::vector<StrokePoint>& stroke)
{
    Guess guess;
    guess.draw(stroke);
    return guess;
}

std::size_t place(double x) { return static_cast<std::size_t>(std::lround(x * (Guess::n_places - 1))); }

} // namespace

TEST_SUITE("frame predict")
{
    TEST_CASE("A stroke of two points is a straight line between them")
    {
        const Guess guess = drawn({{0.25, 0.1}, {0.75, 0.3}});
        CHECK(guess[place(0.5)] == doctest::Approx(0.2));
        CHECK(guess[place(0.25)] == doctest::Approx(0.1));
        CHECK(!guess[place(0.2)]);
        CHECK(!guess[place(0.8)]);
    }

    TEST_CASE("A stroke gives the same diagram whichever way it is drawn")
    {
        const Guess right = drawn({{0.2, 0.1}, {0.5, 0.4}, {0.9, -0.2}}),
                    left = drawn({{0.9, -0.2}, {0.5, 0.4}, {0.2, 0.1}});
        for (std::size_t i = 0; i < Guess::n_places; ++i) {
            CAPTURE(i);
            CHECK(right[i].value_or(9.0) == doctest::Approx(left[i].value_or(9.0)));
        }
    }

    TEST_CASE("A second stroke replaces the part that it passes and leaves the rest")
    {
        Guess guess = drawn({{0.0, 0.1}, {1.0, 0.1}});
        guess.draw(std::vector<StrokePoint>{{0.4, 0.3}, {0.6, 0.3}});
        CHECK(guess[place(0.3)] == doctest::Approx(0.1));
        CHECK(guess[place(0.5)] == doctest::Approx(0.3));
        CHECK(guess[place(0.7)] == doctest::Approx(0.1));
    }

    TEST_CASE("Where a stroke turns back its latter part counts")
    {
        const Guess guess = drawn({{0.2, 0.1}, {0.8, 0.1}, {0.8, 0.2}, {0.5, 0.2}});
        CHECK(guess[place(0.3)] == doctest::Approx(0.1));
        CHECK(guess[place(0.7)] == doctest::Approx(0.2));
    }

    TEST_CASE("An upright part of a stroke is a jump between two neighbouring places")
    {
        const Guess guess = drawn({{0.0, 0.2}, {0.5, 0.2}, {0.5, -0.2}, {1.0, -0.2}});
        CHECK(guess[place(0.5) - 1] == doctest::Approx(0.2));
        CHECK(guess[place(0.5) + 1] == doctest::Approx(-0.2));
    }

    TEST_CASE("What is drawn a little before an end goes on to the end, what is drawn beyond it does not count")
    {
        const Guess near = drawn({{0.02, 0.1}, {0.98, 0.3}});
        CHECK(near[0] == doctest::Approx(0.1));
        CHECK(near[Guess::n_places - 1] == doctest::Approx(0.3));
        const Guess beyond = drawn({{-0.5, 0.0}, {1.5, 0.4}});
        CHECK(beyond[0] == doctest::Approx(0.1));
        CHECK(beyond[Guess::n_places - 1] == doctest::Approx(0.3));
        CHECK(drawn({{-0.5, 0.1}, {-0.2, 0.3}}).is_empty());
        CHECK(drawn({{1.2, 0.1}, {1.5, 0.3}}).is_empty());
    }

    TEST_CASE("No point, one point and numbers that are none draw nothing")
    {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        CHECK(drawn({}).is_empty());
        CHECK(drawn({{0.5, 0.1}}).is_empty());
        CHECK(drawn({{nan, 0.1}, {0.5, nan}, {std::numeric_limits<double>::infinity(), 1.0}}).is_empty());
        CHECK(drawn({{0.1, nan}, {0.2, 0.1}, {nan, 3.0}, {0.4, 0.3}})[place(0.3)] == doctest::Approx(0.2));
    }

    TEST_CASE("An upright stroke far longer than the member draws at one place at most")
    {
        const Guess guess = drawn({{0.5, -1e9}, {0.5, 1e9}});
        std::size_t n = 0;
        for (std::size_t i = 0; i < Guess::n_places; ++i) n += guess[i] ? 1 : 0;
        CHECK(n == 1);
    }
}
