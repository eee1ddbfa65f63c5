#include "femoop/methods/mohr/space_construction.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "femoop/methods/mohr/rounding.h"

namespace femoop::mohr {

namespace {

using Step = ConstructionStep;
using Mark = ConstructionMark;
using std::numbers::pi;

CirclePoint on(const Circle& circle, double angle)
{
    return {sum_of({circle.centre, circle.radius * std::cos(angle)}),
            without_rounding(circle.radius * std::sin(angle), circle.radius)};
}

Step circle_step(ConstructionStage stage, const Circle& circle)
{
    return {stage, {{Mark::Helper, {circle.centre, 0.0}}}, {}, {{{circle.centre, 0.0}, circle.radius, 0.0, 2 * pi}}};
}

/// The arc about `centre` from one point to another of the same distance.
Step::Arc arc(double centre, const CirclePoint& from, const CirclePoint& to)
{
    const auto angle = [&](const CirclePoint& p) { return std::atan2(p.shear, p.normal - centre); };
    return {{centre, 0.0}, std::hypot(from.normal - centre, from.shear), angle(from), angle(to) - angle(from)};
}

} // namespace

double angle_with(const SpacePrincipal& principal, int direction, const Eigen::Vector3d& normal)
{
    const Eigen::Vector3d n = normal.stableNormalized(), d = principal.directions.col(direction);
    return std::atan2(n.cross(d).norm(), std::abs(n.dot(d))); // exact for small angles too
}

std::vector<ConstructionStep> construction(const SpacePrincipal& principal, const Eigen::Vector3d& normal)
{
    using enum ConstructionStage;
    const auto& v = principal.values;
    const auto [largest, upper, lower] = circles(principal);
    std::vector<Step> steps{
        {Axes}, {ThreeValues, {{Mark::First, {v[0], 0.0}}, {Mark::Second, {v[1], 0.0}}, {Mark::Third, {v[2], 0.0}}}}};
    if (largest.radius == 0.0) {
        steps.push_back({Point});
        return steps;
    }
    steps.push_back(circle_step(LargestCircle, largest));
    steps.push_back(circle_step(UpperCircle, upper));
    steps.push_back(circle_step(LowerCircle, lower));
    steps.push_back({SpaceShear, {{Mark::Top, {largest.centre, largest.radius}}}});
    const double alpha = angle_with(principal, 0, normal), gamma = angle_with(principal, 2, normal);
    const CirclePoint a = on(largest, 2 * alpha), b = on(upper, 2 * alpha);
    const CirclePoint c = on(largest, pi - 2 * gamma), d = on(lower, pi - 2 * gamma);
    steps.push_back({FromFirst, {{Mark::Helper, a}, {Mark::Helper, b}}, {{{v[0], 0.0}, a}}, {arc(lower.centre, b, a)}});
    steps.push_back({FromThird, {{Mark::Helper, c}, {Mark::Helper, d}}, {{{v[2], 0.0}, c}}, {arc(upper.centre, d, c)}});
    const Eigen::Vector3d n = principal.directions.transpose() * normal.stableNormalized();
    const Eigen::Vector3d traction(v[0] * n[0], v[1] * n[1], v[2] * n[2]);
    const double along = sum_of({n[0] * traction[0], n[1] * traction[1], n[2] * traction[2]});
    const double across = without_rounding((traction - along * n).norm(), std::max(std::abs(v[0]), std::abs(v[2])));
    steps.push_back({ArcsMeet, {{Mark::N, {along, across}}}});
    return steps;
}

} // namespace femoop::mohr
