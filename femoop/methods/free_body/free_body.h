#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/methods/free_body/body.h"
#include "femoop/model/model.h"
#include "femoop/result/components.h"
#include "femoop/result/results.h"

namespace femoop::free_body {

/// What acts on a body.
enum class ForceKind : std::uint8_t {
    NodeLoad,
    MemberLoad, ///< a point load, or the resultant of what is distributed along a piece
    Reaction,   ///< of a support
    Foundation, ///< the resultant of what a continuous foundation does to a piece
    SectionForces
};

/// A force and a moment on a body at a place.
///
/// Signs  global axes, right-handed
struct Force {
    ForceKind kind = ForceKind::NodeLoad;
    std::optional<NodeId> node;     ///< that it acts on
    std::optional<MemberId> member; ///< likewise
    double x = 0.0;                 ///< along the member
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    /// Of section forces: what the analysis calls them, and whether the body has the face +x' there (else -x', where
    /// they act the other way).
    SectionForces section{};
    bool is_on_plus_face = true;
    /// Of section forces: the member's axes, in rows.
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

    Eigen::Vector3d moment_about(const Eigen::Vector3d& point) const;
};

/// One of the arrows that a force is drawn with: along a global axis, or of section forces along an axis of the member,
/// with the sign that the analysis gives it.
struct ForceComponent {
    std::optional<MemberComponent> of{}; ///< of section forces: N, Vy, ..
    Eigen::Vector3d direction;           ///< in which it acts on the body if it is positive
    double value;
    bool is_moment;
};
/// The three forces, then the three moments.
std::vector<ForceComponent> components(const Force& force);

/// Of a body that is cut off through bars: the point in which the lines of all bars meet but one. Moments about it leave
/// the force of that bar alone unknown.
/// Source  [TimoshenkoYoung1965, ch. 2]
struct RitterPoint {
    MemberId bar;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double arm = 0.0;                    ///< of the bar's tension on the body, counter-clockwise positive
    std::vector<Eigen::Vector3d> others; ///< where the bars are cut that meet in it
};

/// A body with all that acts on it in a load case or combination.
struct FreeBody {
    Body body;
    std::vector<Force> forces;              ///< without those that are nothing but round-off
    std::vector<RitterPoint> ritter_points; ///< of every bar that has one, in the order of the pieces
};

/// The same in other units: every length times this, every force times that.
FreeBody scaled(FreeBody body, double length, double force);

/// What acts on a part of a structure. \pre the results are those of the model
/// Accuracy  what a foundation does is integrated along the exact deflection; all else is exact
FreeBody lift_out(const Model& model, const Results& results, CaseId load_case, const Body& body);

/// The point that moments are taken about if none is chosen: the first Ritter point of a cut through bars; else that of
/// the first section, so that its forces have no arm; else that of the first node.
Eigen::Vector3d usual_moment_point(const FreeBody& body, const Model& model);

/// What a component of a force adds to the sum of moments about an axis through a point.
struct MomentTerm {
    std::size_t force;                   ///< of those on the body
    std::optional<MemberComponent> of{}; ///< of section forces
    Dof dof;                             ///< of other forces: its axis, ux .. rz
    double value;                        ///< of the component
    std::optional<double> arm{};         ///< of a force, positive where a positive one turns as the axis does
    double moment;                       ///< value times arm; of a moment its part about the axis
};

/// An equation of equilibrium of a body: along an axis, or about it through a point.
struct Equation {
    Dof dof = Dof::ux;
    std::vector<double> terms;       ///< of each of the forces
    std::vector<MomentTerm> moments; ///< of an equation of moments: what the terms consist of, without round-off
    double sum = 0.0;                ///< 0 but for rounding
    double size = 0.0; ///< of the largest force, or of the largest moment about the point, in any direction
};

/// All that a model of this kind has: in the plane along x and y and about the point, of a grillage along z and about x
/// and y, in space six.
std::vector<Equation> equations(const FreeBody& body, AnalysisKind kind, const Eigen::Vector3d& about);

} // namespace femoop::free_body
