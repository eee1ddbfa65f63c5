#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

#include "femoop/element/bar.h"
#include "femoop/element/beam.h"

namespace femoop {

/// What a member resists with: its material and section as the four ways a straight member works.
struct MemberProperties {
    Bar axial;             ///< EA
    Bar torsion;           ///< GJ
    Beam xy;               ///< EIz and GAsy, the foundation
    Beam xz;               ///< EIy and GAsz
    double alpha = 0.0;    ///< thermal expansion [1/K]
    double depth = 0.0;    ///< h along y'; 0 when not given; of a tapered member at its first end, like the weight
    double centroid = 0.0; ///< its distance from the -y' fibre
    double weight = 0.0;   ///< density x gravity x A, per unit length
};

/// A joint between one end of a member and its node, per local axis: infinite is rigid, zero released, else a spring.
using JointStiffness = std::array<double, n_local_axes>;

inline constexpr double rigid_joint = std::numeric_limits<double>::infinity();
inline constexpr JointStiffness rigid_joints{rigid_joint, rigid_joint, rigid_joint,
                                             rigid_joint, rigid_joint, rigid_joint};

/// Which strains a constraint takes from a member.
enum class Constraint : std::uint8_t { None, Inextensible, Rigid };

/// What most members lack, kept aside.
struct MemberEndConditions {
    std::array<JointStiffness, 2> joints{rigid_joints, rigid_joints};
    std::array<Eigen::Vector3d, 2> offsets{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    Constraint constraint = Constraint::None;
    bool is_bar = false; ///< carries axial force only
    bool has_offset = false;
    bool has_flexible_joint = false; ///< any joint that is not rigid
};

} // namespace femoop
