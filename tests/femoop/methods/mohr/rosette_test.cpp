#include "femoop/methods/mohr/rosette.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "tests/femoop/methods/mohr/degree.h"

using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

Rosette rosette(const std::array<double, 3>& degrees, const std::array<double, 3>& readings)
{
    return {{degrees[0] * degree, degrees[1] * degree, degrees[2] * degree}, readings};
}

} // namespace

TEST_CASE("A published rosette of 60 degrees gives the strains of its book")
{
    const PlaneState e = strain(rosette({0.0, 60.0, 120.0}, {60.0, 135.0, 264.0})); // Hibbeler, example 10.8
    CHECK(e.x == Approx(60.0));
    CHECK(e.y == Approx(246.0));
    CHECK(2.0 * e.xy == Approx(-258.0 / std::sqrt(3.0)));
}

TEST_CASE("A rosette of 45 degrees has the closed form gamma = 2 e45 - e0 - e90")
{
    const PlaneState e = strain(rosette({0.0, 45.0, 90.0}, {520.0, 360.0, -80.0}));
    CHECK(e.x == Approx(520.0));
    CHECK(e.y == Approx(-80.0));
    CHECK(2.0 * e.xy == Approx(2.0 * 360.0 - 520.0 + 80.0));
}

TEST_CASE("Gauges in any directions find the strain that they were put on")
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> component(-900.0, 900.0), angle(-4.0, 4.0);
    int n_tried = 0;
    while (n_tried < 1000) {
        const PlaneState state{component(random), component(random), component(random)};
        Rosette r{{angle(random), angle(random), angle(random)}, {}};
        if (why_not(r)) continue;
        double worst = 1.0;
        for (std::size_t i = 0; i < 3; ++i) {
            r.readings[i] = rotated(state, r.angles[i]).x;
            worst = std::min(worst, std::abs(std::sin(r.angles[i] - r.angles[(i + 1) % 3])));
        }
        ++n_tried;
        const PlaneState found = strain(r);
        CAPTURE(worst);
        CHECK((tensor(found) - tensor(state)).cwiseAbs().maxCoeff() < 1e-11 / (worst * worst));
    }
}

TEST_CASE("Equal readings are a point circle without rounding")
{
    const PlaneState e = strain(rosette({10.0, 70.0, 130.0}, {123.456, 123.456, 123.456}));
    CHECK(e == PlaneState{123.456, 123.456, 0.0});
}

TEST_CASE("Two gauges along one direction are refused also half a turn apart")
{
    const auto same = why_not(rosette({10.0, 45.0, 190.0}, {}));
    REQUIRE(same);
    CHECK(same->first == 0);
    CHECK(same->second == 2);
    CHECK(why_not(rosette({0.0, 90.0, 90.05}, {})));
    CHECK_FALSE(why_not(rosette({0.0, 90.0, 91.0}, {})));
}

TEST_SUITE_END();
