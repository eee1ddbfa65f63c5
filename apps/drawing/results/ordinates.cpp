#include "apps/drawing/results/ordinates.h"

#include <cmath>
#include <utility>

namespace drawing {

namespace {

using Eigen::Vector3d;
using femoop::MemberComponent;
using femoop::Side;

/// The direction in which positive values are drawn.
Vector3d positive_side(const Scene& scene, const MemberShape& member, MemberComponent component)
{
    const bool in_xz = component == MemberComponent::My || component == MemberComponent::Vz;
    const Vector3d side = in_xz ? member.z() : member.y();
    if (drawing::is_moment(component)) {
        const bool on_tension = scene.options.moment_side == MomentSide::Tension;
        return on_tension ? Vector3d(-side) : side;
    }
    // The upper side, or the left one of a column, whichever way the member was drawn.
    const bool is_turned = scene.is_flat() && (side.y() < -1e-9 || (std::abs(side.y()) <= 1e-9 && side.x() > 0.0));
    return is_turned ? Vector3d(-side) : side;
}

/// Values along one line, close enough together that the line between them is the curve on the sheet.
class Ordinates {
public:
    Ordinates(const LineFunction& function, double tolerance) : function_(function), tolerance_(tolerance) {}

    std::vector<Ordinate> sample()
    {
        const std::vector<double> breaks = function_.breaks();
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
            const Ordinate begin{breaks[i], function_.value(breaks[i], Side::After)};
            const Ordinate end{breaks[i + 1], function_.value(breaks[i + 1], Side::Before)};
            points_.push_back(begin);
            subdivide(begin, end, 0);
            points_.push_back(end);
        }
        return std::move(points_);
    }

private:
    void subdivide(const Ordinate& a, const Ordinate& b, int depth)
    {
        constexpr int least_depth = 2; // an S-shaped curve may cross its chord in the middle
        constexpr int most_depth = 7;
        if (depth >= most_depth || !(b.x > a.x)) return;
        const double x = 0.5 * (a.x + b.x);
        const Ordinate middle{x, function_.value(x)};
        const bool is_straight = std::abs(middle.value - 0.5 * (a.value + b.value)) <= tolerance_;
        if (is_straight && depth >= least_depth) return;
        if (is_straight && depth == 0 && is_straight_at(a, b, 0.25) && is_straight_at(a, b, 0.81)) return;
        subdivide(a, middle, depth + 1);
        points_.push_back(middle);
        subdivide(middle, b, depth + 1);
    }

    bool is_straight_at(const Ordinate& a, const Ordinate& b, double t) const
    {
        const double value = function_.value(a.x + t * (b.x - a.x));
        return std::abs(value - (a.value + t * (b.value - a.value))) <= tolerance_;
    }

    const LineFunction& function_;
    double tolerance_;
    std::vector<Ordinate> points_;
};

} // namespace

bool is_moment(MemberComponent component)
{
    return component == MemberComponent::Mz || component == MemberComponent::My;
}

bool has_signs(const Scene& scene, MemberComponent component)
{
    return !drawing::is_moment(component) || scene.options.moment_side == MomentSide::Compression;
}

SymbolFrame diagram_frame(const Scene& scene, const MemberShape& member, MemberComponent component)
{
    return scene.projection.frame(member.start, member.x(), positive_side(scene, member, component));
}

std::vector<Ordinate> ordinates_of(const LineFunction& function, double tolerance)
{
    return Ordinates(function, tolerance).sample();
}

} // namespace drawing
