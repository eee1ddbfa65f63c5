#pragma once

#include <optional>

#include "femoop/methods/mohr/criterion.h"
#include "femoop/methods/mohr/state.h"

namespace femoop::mohr {

/// A state at a point and what is asked of it.
struct PointQuestion {
    State state;
    ShearRule rule = ShearRule::ClockwiseUp; ///< in which way the circle's shear is drawn
    double angle = 0.0;                      ///< of a plane state's turned axes, and of its plane's normal [rad]
    Eigen::Vector3d normal{1.0, 1.0, 1.0};   ///< of a plane in space, of any length but 0
    std::optional<Criterion> criterion{};    ///< of failure; it judges stresses
    Strength strength{};                     ///< in the unit of the stresses
    double strain_unit = 1.0;                ///< what a strain's components count in, where stresses follow from them
};

/// Everything that a textbook's table of Mohr's circle holds.
///
/// Units  those of the state's components, of stresses that follow from strains those of E; angles are radians
struct PointResults {
    PlaneState plane{}, turned{};         ///< the components in x and y, and in the turned axes
    Circle circle{};                      ///< of `plane`; its radius is the largest shear in the plane
    PlanePrincipal principal{};           ///< likewise
    std::optional<double> second_angle{}; ///< from x to the second principal direction; absent with the first
    std::optional<double> shear_angle{};  ///< from x to the normal of a plane of largest shear; likewise
    CirclePoint pole_of_planes{}, pole_of_normals{};

    std::optional<SpaceState>
        space{}; ///< with its third direction; absent for second moments of area, and then all below
    SpacePrincipal space_principal{};
    double absolute_shear = 0.0; ///< largest on any plane
    Deviator deviator{};
    Invariants invariants{};
    OnPlane on_plane{}; ///< on the plane of the normal

    std::optional<SpaceState> stress{};               ///< of a strain whose E and nu are given
    std::optional<SpacePrincipal> principal_stress{}; ///< of `stress`
    std::optional<Safety> safety{}; ///< by the criterion: of the state if it is a stress, else of `stress`
};

/// \pre a criterion has a stress to judge and can use the strength (`why_not` of criterion.h)
PointResults point_results(const PointQuestion& question);

/// The pole's rule for a state of a kind: the shear of second moments of area points down, so that their axes and
/// circle turn the same way.
ShearRule usual_rule(Kind kind);

} // namespace femoop::mohr
