#include "femoop/methods/mohr/construction.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

constexpr PlaneState state{-20.0, 90.0, 60.0};
constexpr double angle = 0.4;

const ConstructionStep& step_of(const std::vector<ConstructionStep>& steps, ConstructionStage stage)
{
    for (const ConstructionStep& step : steps)
        if (step.stage == stage) return step;
    FAIL("there is no such step");
    return steps.front();
}

} // namespace

TEST_CASE("The points of a construction lie on its circle and the diameter passes through its centre")
{
    const auto steps = construction(state, angle);
    const Circle c = circle(state);
    for (const ConstructionStep& step : steps)
        for (const auto& point : step.points) {
            CAPTURE(static_cast<int>(point.mark));
            const double distance = std::hypot(point.at.normal - c.centre, point.at.shear);
            CHECK(distance == Approx(point.mark == ConstructionMark::C ? 0.0 : c.radius));
        }
    const auto& [from, to] = step_of(steps, ConstructionStage::Diameter).lines.front();
    CHECK(0.5 * (from.normal + to.normal) == Approx(c.centre));
    CHECK(from.shear + to.shear == 0.0);
}

TEST_CASE("Each line from the pole is parallel to the plane that it stands for")
{
    const auto steps = construction(state, angle);
    const auto slope = [](const ConstructionStep::Line& line) {
        return std::atan2(line.to.shear - line.from.shear, line.to.normal - line.from.normal);
    };
    const double quarter = 2.0 * std::atan(1.0);
    const auto is_parallel = [&](double line, double normal) {
        return std::abs(as_direction(line - normal - quarter)) < 1e-12;
    };
    CHECK(is_parallel(slope(step_of(steps, ConstructionStage::Pole).lines[0]), 0.0));
    CHECK(is_parallel(slope(step_of(steps, ConstructionStage::Plane).lines[0]), angle));
    const auto& planes = step_of(steps, ConstructionStage::PrincipalPlanes).lines;
    CHECK(is_parallel(slope(planes[0]), *principal(state).angle));
    CHECK(is_parallel(slope(planes[1]), *principal(state).angle + quarter));
}

TEST_CASE("The construction of a point circle ends with the point")
{
    const auto steps = construction({7.0, 7.0, 0.0}, angle);
    CHECK(steps.back().stage == ConstructionStage::Point);
    CHECK(steps.size() == 4);
}

TEST_SUITE_END();
