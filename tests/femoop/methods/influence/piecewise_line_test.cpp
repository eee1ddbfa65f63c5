#include <doctest/doctest.h>

#include "femoop/methods/influence/piecewise_line.h"

using namespace femoop;
using namespace femoop::influence;

namespace {

/// Up to 1.5 at s = 3, down to -0.5 at 7, level at 0 to the end.
PiecewiseLine roof() { return {{{0.0, 3.0, {0.0, 0.5}}, {3.0, 7.0, {1.5, -0.5}}, {7.0, 12.0, {}}}}; }

} // namespace

TEST_CASE("A line is zero beyond the ends of its path")
{
    PiecewiseLine line{{{0.0, 2.0, {3.0, 1.0}}}};
    CHECK(line.value(-0.1) == 0.0);
    CHECK(line.value(0.0) == 3.0);
    CHECK(line.value(2.0) == 5.0);
    CHECK(line.value(2.0, Side::Before) == 5.0);
    CHECK(line.value(2.1) == 0.0);
}

TEST_CASE("At a jump a line has a value on either side")
{
    CHECK(roof().value(7.0, Side::Before) == doctest::Approx(-0.5));
    CHECK(roof().value(7.0, Side::After) == 0.0);
    CHECK(roof().jumps() == std::vector<double>{7.0});
    constexpr double hair = 1e-14;
    for (const double s : {7.0 - hair, 7.0 + hair}) {
        CHECK(roof().value(s, Side::Before) == doctest::Approx(-0.5));
        CHECK(roof().value(s, Side::After) == 0.0);
    }
}

TEST_CASE("The areas of either sign add up to the integral")
{
    const LineAreas areas = roof().areas();
    CHECK(areas.positive == doctest::Approx(0.5 * 3.0 * 1.5 + 0.5 * 3.0 * 1.5));
    CHECK(areas.negative == doctest::Approx(-0.5 * 1.0 * 0.5));
}

TEST_CASE("An extreme is found at a kink, before a jump, and at the root of the slope")
{
    CHECK(roof().max().positions == std::vector<double>{3.0});
    CHECK(roof().min().value == doctest::Approx(-0.5));
    CHECK(roof().min().positions == std::vector<double>{7.0});
    const PiecewiseLine parabola{{{0.0, 4.0, {0.0, 3.0, -1.0}}}}; // 3 t - t^2
    CHECK(parabola.max().value == doctest::Approx(2.25));
    CHECK(parabola.max().positions.front() == doctest::Approx(1.5));
}

TEST_CASE("Of equal extremes every place is told once")
{
    const PiecewiseLine waves{{{0.0, 2.0, {0.0, 2.0, -1.0}}, {2.0, 4.0, {0.0, 2.0, -1.0}}}}; // 2 t - t^2, twice
    const LineExtreme max = waves.max();
    REQUIRE(max.positions.size() == 2);
    CHECK(max.positions[0] == doctest::Approx(1.0));
    CHECK(max.positions[1] == doctest::Approx(3.0));
    const LineExtreme min = waves.min();
    CHECK(min.value == 0.0);
    CHECK(min.positions == std::vector<double>{0.0, 2.0, 4.0});
}

TEST_CASE("Where a line keeps its largest value the stretch's ends are told")
{
    const PiecewiseLine bridge{{{0.0, 2.0, {0.0, 0.5}}, {2.0, 5.0, {1.0}}, {5.0, 6.0, {1.0}}, {6.0, 8.0, {1.0, -0.5}}}};
    const LineExtreme max = bridge.max();
    CHECK(max.positions == std::vector<double>{2.0, 6.0});
    CHECK(max.is_level_after == std::vector<bool>{true, false});
}

TEST_CASE("A line that is zero everywhere is level from end to end")
{
    const PiecewiseLine nothing{{{0.0, 2.0, {}}, {2.0, 5.0, {}}}};
    CHECK(nothing.max().value == 0.0);
    CHECK(nothing.max().positions == std::vector<double>{0.0, 5.0});
    CHECK(nothing.jumps().empty());
}
