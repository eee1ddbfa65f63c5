#pragma once

#include "apps/drawing/geometry/structure_shape.h"
#include "apps/drawing/results/solved_case.h"
#include "apps/drawing/sketch/scene.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace drawing {

/// The line of thrust of a plane frame: where the resultant of all that passes through a section acts. It lies off the
/// axis by e = -M/N, to the side of y'; through a hinge it passes, and an arch whose axis it follows is not bent.
struct ThrustLine {
    /// Of one member, in model coordinates; broken where the resultant hardly has a part along the member, so that it
    /// meets the section far away.
    std::vector<std::vector<Eigen::Vector3d>> parts;
    double largest_eccentricity = 0.0; ///< |e| of those parts
};

/// What is far away and hardly there.
struct ThrustLimits {
    double axial_force = 0.0;  ///< the least |N| of a resultant that is drawn
    double eccentricity = 0.0; ///< the largest |e|
};

ThrustLine thrust_line(const MemberShape& member, const femoop::Curve& curve, const ThrustLimits& limits);

/// Draws it for all members. \returns the largest eccentricity that is drawn, and of which member; nothing where no
/// line is drawn. \pre a plane frame
struct LargestEccentricity {
    femoop::MemberId member;
    double value = 0.0;
};
std::optional<LargestEccentricity> draw_thrust(const Scene& scene, const SolvedCase& solved);

} // namespace drawing
