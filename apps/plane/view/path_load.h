#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/plane/view/plate_outline.h"
#include "femoop/plane/model/plane_load.h"
#include "ui/text/display_units.h"

namespace plane {

/// A load along a stretch of a curve, with its factor in the case that is shown, in global axes.
struct PathLoad {
    static constexpr int samples = 64; ///< that a load is looked at along a stretch

    const femoop::plane::CurveLoad& load;
    const CurvePath& path;
    double factor = 1.0;

    Eigen::Vector2d at(double s) const; ///< \param s  length from the start of the curve
    double place(double share) const { return path.s.front() + share * path.extent(); }
    double share_of_largest() const; ///< of the stretch, as far as samples show
    double largest() const { return at(place(share_of_largest())).norm(); }
};

ui::Measure measure_of(femoop::plane::CurveLoadKind kind);

using NumberText = std::function<std::string(double)>;
/// "3 kN", or "1 … 3 kN" of what varies over some places.
std::string range_text(const std::vector<double>& values, const NumberText& with_unit, const NumberText& bare);

} // namespace plane
