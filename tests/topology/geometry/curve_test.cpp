#include <doctest/doctest.h>

#include <numbers>

#include "topology/geometry/curve.h"

using namespace topology;
using doctest::Approx;

namespace {

constexpr double half_turn = std::numbers::pi;

Curve ellipse(double a, double b) { return EllipticArc{{2.0, 1.0}, {a, 0.0}, {0.0, b}, 0.0, 2.0 * half_turn}; }

/// The graph of y = x^3 - x from -2 to 2.
Curve cubic_graph()
{
    return CubicBezier{{{{-2.0, -6.0}, {-2.0 / 3.0, 26.0 / 3.0}, {2.0 / 3.0, -26.0 / 3.0}, {2.0, 6.0}}}};
}

} // namespace

TEST_SUITE("curves in a plane")
{
    TEST_CASE("Length and area of a whole ellipse are those of the closed forms, wherever the origin lies")
    {
        for (const FlatPoint origin : {FlatPoint{0.0, 0.0}, FlatPoint{-7.0, 40.0}}) {
            CHECK(ellipse(3.0, 3.0).area({}, origin) == Approx(9.0 * half_turn).epsilon(1e-13));
            CHECK(ellipse(3.0, 2.0).area({}, origin) == Approx(6.0 * half_turn).epsilon(1e-13));
        }
        CHECK(ellipse(3.0, 3.0).length({}) == Approx(6.0 * half_turn).epsilon(1e-14));
        CHECK(ellipse(3.0, 2.0).length({}) == Approx(15.865439589290590).epsilon(1e-12)); // 12 E(5/9), [DLMF 19.9]
    }

    TEST_CASE("Parts of a curve add up to the whole, in length and in area, and run both ways")
    {
        const FlatPoint origin{0.3, -0.2};
        for (const Curve& curve : {cubic_graph(), ellipse(3.0, 2.0), Curve(Segment{{1.0, 2.0}, {4.0, -3.0}})}) {
            CHECK(curve.length({0.0, 0.37}) + curve.length({0.37, 1.0}) == Approx(curve.length({})).epsilon(1e-12));
            CHECK(curve.area({0.0, 0.37}, origin) + curve.area({0.37, 1.0}, origin) ==
                  Approx(curve.area({}, origin)).epsilon(1e-12));
            CHECK(curve.area({1.0, 0.0}, origin) == Approx(-curve.area({}, origin)).epsilon(1e-12));
        }
    }

    TEST_CASE("The length of a curve with a cusp ends, and is right")
    {
        const Curve cusp = CubicBezier{{{{0.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {1.0, 0.0}}}};
        double chords = 0.0;
        for (int i = 0; i < 20000; ++i) chords += distance(cusp.at(i / 20000.0), cusp.at((i + 1) / 20000.0));
        CHECK(cusp.length({}) == Approx(chords).epsilon(1e-7));
    }

    TEST_CASE("A curve's box is touched on all four sides")
    {
        const FlatBox box = ellipse(3.0, 2.0).box({0.0, 0.5}); // the upper half
        CHECK(box.low.x == Approx(-1.0));
        CHECK(box.high.x == Approx(5.0));
        CHECK(box.low.y == Approx(1.0));
        CHECK(box.high.y == Approx(3.0));
        CHECK(cubic_graph().box({0.4, 0.9}).low.y == Approx(-2.0 / (3.0 * std::sqrt(3.0)))); // its minimum
    }

    TEST_CASE("Between turns of y every height is taken once, and found")
    {
        const Curve curve = cubic_graph();
        const std::vector<double> turns = curve.turns_of_y({});
        REQUIRE(turns.size() == 2);
        CHECK(curve.at(turns[0]).x == Approx(-1.0 / std::sqrt(3.0)));
        const double t = curve.at_height(0.1, {turns[0], turns[1]});
        CHECK(curve.at(t).y == Approx(0.1).epsilon(1e-13));
        CHECK(ellipse(3.0, 2.0).turns_of_y({}).size() == 2);
        CHECK(Curve(Segment{{0.0, 0.0}, {1.0, 5.0}}).turns_of_y({}).empty());
    }

    TEST_CASE("The line to the nearest place of a curve is square to it, across a circle's start as well")
    {
        const Curve curve = cubic_graph();
        for (const FlatPoint p : {FlatPoint{0.3, 2.0}, FlatPoint{-1.0, -0.5}, FlatPoint{1.2, 0.4}}) {
            const double t = curve.nearest(p);
            CHECK(std::abs(dot(curve.at(t) - p, curve.derivative(t))) < 1e-9);
            for (int i = 0; i <= 1000; ++i)
                CHECK(distance(curve.at(i / 1000.0), p) >= distance(curve.at(t), p) - 1e-12);
        }
        const Curve circle = ellipse(3.0, 3.0);
        const FlatPoint below_start = circle.at(1.0 - 1e-9);
        CHECK(distance(circle.at(circle.nearest(below_start)), below_start) < 1e-14);
    }

    TEST_CASE("A cubic that crosses itself does so where both parameters give one place")
    {
        const Curve loop = CubicBezier{{{{0.0, 0.0}, {3.0, 3.0}, {-2.0, 3.0}, {1.0, 0.0}}}};
        const std::vector<double> t = loop.self_crossing();
        REQUIRE(t.size() == 2);
        CHECK(t[0] < t[1]);
        CHECK(distance(loop.at(t[0]), loop.at(t[1])) < 1e-14);
        CHECK(cubic_graph().self_crossing().empty());
        CHECK(ellipse(3.0, 2.0).self_crossing().empty());
    }

    TEST_CASE("Where a control point lies on its end the direction is that of the curve a little further on")
    {
        const Curve curve = CubicBezier{{{{0.0, 0.0}, {0.0, 0.0}, {1.0, 2.0}, {3.0, 2.0}}}};
        const FlatVector start = curve.direction({0.0, 1.0});
        CHECK(start.y / start.x == Approx(2.0).epsilon(0.01));
        const FlatVector back = curve.direction({1.0, 0.0});
        CHECK(back.x == Approx(-1.0));
    }
}
