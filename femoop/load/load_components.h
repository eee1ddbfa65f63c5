#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "femoop/geometry/member_geometry.h"
#include "femoop/model/load.h"

namespace femoop {

/// One component of a load on a member, as it is given: where it acts, which way, how large.
struct LoadComponent {
    enum class Kind : std::uint8_t {
        Line,  ///< per unit length, linear from `start` at `from` to `end` at `to`
        Point, ///< `start` at `from`
        End    ///< likewise, on the member's own end, inside its releases
    };
    Kind kind = Kind::Line;
    Dof dof = Dof::uy; ///< along, or of a moment about, this one of `axes`
    LoadAxes axes = LoadAxes::Global;
    double from = 0.0, to = 0.0;   ///< along the member, held to it; the same but of a line
    double start = 0.0, end = 0.0; ///< 0 at the end but of a line
    bool is_projected = false;     ///< per unit of the length that shows square to the component, not of the member's
};

/// All of a load, in the order in which they are given. Temperatures and misfits have none.
/// \param L  length of the member's flexible part
std::vector<LoadComponent> components_of(const MemberLoad& load, double L);

/// Which way a positive value acts, or about which axis, along global axes; of length 1.
Eigen::Vector3d direction_of(const LoadComponent& component, const MemberGeometry& geometry);

} // namespace femoop
