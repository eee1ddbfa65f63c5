#include "femoop/methods/mohr/loading_path.h"

#include <doctest/doctest.h>

using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

const LoadingPath path{{10.0, 4.0, 0.0}, {30.0, -6.0, 8.0}, {-7.0, 2.0, 5.0}};

} // namespace

TEST_CASE("A loading path goes through its states and halfway between two through their mean")
{
    CHECK(state_on(path, 0.0) == path[0]);
    CHECK(state_on(path, 0.5) == path[1]);
    CHECK(state_on(path, 1.0) == path[2]);
    CHECK(state_on(path, 7.0) == path[2]);
    CHECK(state_on(path, 0.25).x == Approx(20.0));
    CHECK(state_on(path, 0.25).xy == Approx(4.0));
    CHECK(state_on({path[1]}, 0.3) == path[1]);
}

TEST_CASE("The stress path of proportional loading from nothing is a straight line through the origin")
{
    const auto points = stress_path({{}, {30.0, -6.0, 8.0}}, 9);
    REQUIRE(points.size() == 10);
    const Circle end = circle({30.0, -6.0, 8.0});
    for (const CirclePoint& p : points) CHECK(p.shear * end.centre == Approx(p.normal * end.radius));
    CHECK(points.back().shear == Approx(end.radius));
}

TEST_CASE("The stress path of one state is its point and of none is nothing")
{
    CHECK(stress_path({{30.0, -6.0, 8.0}}, 9).size() == 1);
    CHECK(stress_path({}, 9).empty());
}

TEST_SUITE_END();
