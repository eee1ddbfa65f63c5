#include "apps/drawing/results/thrust_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drawing {

using Eigen::Vector3d;
using femoop::Curve;
using femoop::MemberComponent;
using femoop::Side;

namespace {

constexpr double hardly_there = 1e-3; // of the largest axial force
constexpr double far_away = 0.5;      // of the structure's size
constexpr int parts_of_piece = 32;

/// The pieces of one member's line, one point after the other.
class ThrustWalk {
public:
    ThrustWalk(const MemberShape& member, const Curve& curve, const ThrustLimits& limits)
        : member_(member), curve_(curve), limits_(limits)
    {}

    ThrustLine line()
    {
        const std::vector<double> breaks = curve_.breaks();
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
            take(breaks[i], Side::After);
            for (int k = 1; k < parts_of_piece; ++k)
                take(std::lerp(breaks[i], breaks[i + 1], static_cast<double>(k) / parts_of_piece), Side::After);
            take(breaks[i + 1], Side::Before);
        }
        std::erase_if(line_.parts, [](const auto& part) { return part.size() < 2; });
        return std::move(line_);
    }

private:
    void take(double x, Side side)
    {
        const double N = curve_.value(MemberComponent::N, x, side), M = curve_.value(MemberComponent::Mz, x, side);
        const bool is_there = std::abs(N) > limits_.axial_force && std::abs(M) <= limits_.eccentricity * std::abs(N);
        if (!is_there) {
            is_broken_ = true;
            return;
        }
        if (std::exchange(is_broken_, false)) line_.parts.emplace_back();
        const double e = -M / N;
        line_.parts.back().push_back(member_.at(x) + e * member_.y());
        line_.largest_eccentricity = std::max(line_.largest_eccentricity, std::abs(e));
    }

    const MemberShape& member_;
    const Curve& curve_;
    const ThrustLimits& limits_;
    ThrustLine line_;
    bool is_broken_ = true;
};

} // namespace

ThrustLine thrust_line(const MemberShape& member, const Curve& curve, const ThrustLimits& limits)
{
    return ThrustWalk(member, curve, limits).line();
}

std::optional<LargestEccentricity> draw_thrust(const Scene& scene, const SolvedCase& solved)
{
    const double N = largest_value(solved, MemberComponent::N, scene.shape.size);
    if (!(N > 0.0)) return std::nullopt;
    const ThrustLimits limits{hardly_there * N, far_away * scene.shape.size};
    const ui::Stroke stroke = scene.sketch.stroke(ui::Role::Reaction);
    std::optional<LargestEccentricity> largest;
    for (std::size_t i = 0; i < scene.shape.members.size(); ++i) {
        const femoop::MemberId id(i);
        const ThrustLine line = thrust_line(scene.shape[id], solved[id], limits);
        for (const std::vector<Vector3d>& part : line.parts) {
            std::vector<ui::Point> points;
            for (const Vector3d& place : part) points.push_back(scene.projection(place));
            scene.sketch.polyline(points, stroke, Clearance::Soft);
        }
        if (line.parts.empty() || (largest && largest->value >= line.largest_eccentricity)) continue;
        largest = LargestEccentricity{id, line.largest_eccentricity};
    }
    return largest;
}

} // namespace drawing
