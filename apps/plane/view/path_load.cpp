#include "apps/plane/view/path_load.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace plane {

namespace {

namespace fp = femoop::plane;
using Eigen::Vector2d;

double value_or_zero(const std::optional<fp::Field>& field, const fp::FieldPlace& at)
{
    return field ? fp::value(*field, at) : 0.0;
}

} // namespace

Vector2d PathLoad::at(double s) const
{
    const auto [there, part] = path.at(s);
    const fp::FieldPlace where{.x = there.x(), .y = there.y(), .s = s, .length = path.length};
    if (load.kind == fp::CurveLoadKind::Pressure)
        return -factor * value_or_zero(load.value, where) * path.outward(part);
    const Vector2d q = factor * Vector2d(value_or_zero(load.qx, where), value_or_zero(load.qy, where));
    if (load.axes == femoop::LoadAxes::Global) return q;
    const Vector2d along = (path.line[part + 1] - path.line[part]).normalized();
    return q.x() * along + q.y() * Vector2d(-along.y(), along.x());
}

double PathLoad::share_of_largest() const
{
    double best = 0.0, most = -1.0;
    for (int i = 0; i <= samples; ++i) {
        const double share = static_cast<double>(i) / samples, size = at(place(share)).norm();
        if (size <= most * (1.0 + 1e-9)) continue;
        most = size;
        best = share;
    }
    return best;
}

ui::Measure measure_of(fp::CurveLoadKind kind)
{
    return kind == fp::CurveLoadKind::Line ? ui::Measure::ForcePerLength : ui::Measure::Stress;
}

std::string range_text(const std::vector<double>& values, const NumberText& with_unit, const NumberText& bare)
{
    if (values.empty()) return {};
    const auto [low, high] = std::ranges::minmax(values);
    if (high - low <= 1e-9 * std::max(std::abs(low), std::abs(high))) return with_unit(high);
    return bare(low) + " … " + with_unit(high);
}

} // namespace plane
