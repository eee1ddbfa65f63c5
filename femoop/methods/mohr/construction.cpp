#include "femoop/methods/mohr/construction.h"

#include <numbers>

namespace femoop::mohr {

namespace {

using Step = ConstructionStep;
using Mark = ConstructionMark;
using std::numbers::pi;
constexpr auto rule = ShearRule::ClockwiseUp;

/// The points that every step refers to.
struct Points {
    CirclePoint x, y, c, first, second, top, bottom, pole, n;
};

Points points_of(const PlaneState& state, double angle)
{
    const auto [centre, radius] = circle(state);
    const PlanePrincipal p = principal(state);
    return {.x = face_point(state, 0.0, rule),
            .y = face_point(state, 0.5 * pi, rule),
            .c = {centre, 0.0},
            .first = {p.first, 0.0},
            .second = {p.second, 0.0},
            .top = {centre, radius},
            .bottom = {centre, -radius},
            .pole = pole(state, rule),
            .n = face_point(state, angle, rule)};
}

} // namespace

std::vector<ConstructionStep> construction(const PlaneState& state, double angle)
{
    using enum ConstructionStage;
    const Points at = points_of(state, angle);
    const double radius = circle(state).radius;
    std::vector<Step> steps{{Axes}, {FaceX, {{Mark::X, at.x}}}, {FaceY, {{Mark::Y, at.y}}}};
    if (radius == 0.0) {
        steps.push_back({Point, {{Mark::C, at.c}}});
        return steps;
    }
    steps.push_back({Diameter, {{Mark::C, at.c}}, {{at.x, at.y}}});
    steps.push_back({Circle, {}, {}, {{at.c, radius, 0.0, 2.0 * pi}}});
    steps.push_back({PrincipalValues, {{Mark::First, at.first}, {Mark::Second, at.second}}});
    steps.push_back({LargestShear, {{Mark::Top, at.top}, {Mark::Bottom, at.bottom}}});
    steps.push_back({Pole, {{Mark::P, at.pole}}, {{at.x, at.pole}}});
    steps.push_back({PrincipalPlanes, {}, {{at.pole, at.first}, {at.pole, at.second}}});
    steps.push_back({Plane, {{Mark::N, at.n}}, {{at.pole, at.n}}});
    return steps;
}

} // namespace femoop::mohr
