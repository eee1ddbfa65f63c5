#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "femoop/model/ids.h"
#include "femoop/model/model.h"

namespace femoop::cross {

using EndId = Id<struct CrossEndTag>;     ///< index of Problem::ends: a column of the sheet
using JointId = Id<struct CrossJointTag>; ///< index of Problem::joints

/// What is done with a joint whose rotation one member end alone resists: a pinned end, or a support with an overhang.
enum class FarEnds : std::uint8_t {
    Modified,        ///< it is never locked: its member takes 3EI/L, and fixed-end moments for a hinged end
    ReleasedOnSheet, ///< its member takes 3EI/L, but the sheet begins with both ends locked: it is balanced once
    Plain            ///< it is locked and balanced like every joint
};

/// How much of a structure is balanced.
enum class Extent : std::uint8_t {
    Whole,
    Half ///< by symmetry (femoop/methods/cross/symmetry.h): the joints on one side of the axis; the others turn with
         ///< them
};

/// One end of a member at a joint, or a rotational spring of its support: a column of the sheet.
struct End {
    NodeId node;
    std::optional<MemberId> member; ///< nothing: the spring of the node's support
    std::size_t which = 0;          ///< 0: the member's first end, 1: its second
    std::optional<EndId> far;       ///< the member's other end
    std::optional<JointId> joint;   ///< nothing where the node is not balanced
    std::string label;              ///< "AB": the end at A of the member between A and B
    double stiffness = 0.0;         ///< moment that turns this end by 1 rad, the far end held or hinged
    double carry_over = 0.0;        ///< what part of a balancing moment arrives at the far end
    double factor = 0.0;            ///< its share of the joint's stiffness
    bool is_overhang = false;       ///< of a part that statics alone determines
    bool is_hinged = false;         ///< FarEnds::Modified: its joint is never locked, so its moment stays
};

/// A joint that is locked, and balanced by turning it.
struct Joint {
    NodeId node;
    std::vector<EndId> ends;
    double stiffness = 0.0;        ///< sum over its ends [moment/rad]
    bool is_released_once = false; ///< FarEnds::ReleasedOnSheet: nothing is carried to it again
};

/// What acts on the locked structure: the first row of a sheet.
struct Loading {
    std::vector<double> fixed_end;  ///< of every end
    std::vector<double> joint_load; ///< moment on every joint from outside
};

/// How a member bends: forces on its ends p = K d + f, where d = (v1, th1, v2, th2) across its axis.
struct MemberAction {
    std::array<NodeId, 2> nodes;
    std::array<std::optional<EndId>, 2> ends; ///< none: a bar
    Eigen::Vector2d x = Eigen::Vector2d::UnitX(), y = Eigen::Vector2d::UnitY();
    double length = 0.0;                          ///< between its nodes
    double EI_over_L = 0.0;                       ///< 0: a bar; of a tapered member with the EI of its first end
    Eigen::Matrix4d K = Eigen::Matrix4d::Zero();  ///< rotations of hinged ends condensed
    Eigen::Vector4d f = Eigen::Vector4d::Zero();  ///< with every joint locked and every prop in place
    Eigen::Vector2d fx = Eigen::Vector2d::Zero(); ///< forces along the axis that hold its span loads
    bool is_axially_rigid = true;                 ///< false where a release lets its ends part
    bool has_foundation = false;
    bool is_tapered = false;
    bool is_overhang = false;
};

/// A way in which axially rigid members let the locked joints move, with the one prop that prevents it.
struct Sway {
    NodeId prop;                               ///< the node that is held
    Eigen::Vector2d direction;                 ///< along which; it moves by 1 in the mode
    std::vector<Eigen::Vector2d> displacement; ///< of every node
    std::vector<double> chord_rotation;        ///< of every member [rad], counter-clockwise
    double scale = 1.0;                        ///< the mode's part that is distributed, so that the largest fixed-end
                                               ///< moment is 100
    Loading loading;                           ///< fixed-end moments of that part
};

/// A force that a node's displacement meets: a spring of a support.
struct GroundSpring {
    NodeId node;
    Eigen::Vector2d direction;
    double stiffness = 0.0, ground = 0.0;
};

enum class SymmetryKind : std::uint8_t { Symmetric, Antisymmetric };

/// What stands where on the other side of a vertical axis. Turning a joint turns its mirror image with it, so that
/// every state that half of the joints reach is one of the whole structure.
struct Mirror {
    SymmetryKind kind = SymmetryKind::Symmetric;
    double x = 0.0;                ///< of the axis
    std::vector<EndId> ends;       ///< the image of every end
    std::vector<JointId> joints;   ///< the image of every joint; its own on the axis
    std::vector<bool> is_balanced; ///< every joint: left of the axis; on it too where antisymmetric turns are worked
    std::vector<bool> is_on_sheet; ///< every end: of the half that is balanced

    /// Of an image's moment and rotation: mirrored, both turn the other way.
    double sign() const { return kind == SymmetryKind::Symmetric ? -1.0 : 1.0; }
};

/// A plane structure as moment distribution sees it: joints, member ends with their factors, what acts on them, and the
/// ways in which it can sway.
///
///        A         B         C        ends AB BA BC CB, joints B and C: turning B by th gives
///        |----AB BA|BC-----CB|        M_BA = s th at B and C s th at A, with s = 4EI/L and C = 1/2
///
/// Signs    moments act on the member ends, rotations likewise: counter-clockwise positive
/// Units    the model's base units, rad
/// Assumes  members axially rigid, small displacements; shear strain, semi-rigid ends and foundations enter s and C
/// Source   [Cross1930]
struct Problem {
    CaseId load_case;
    FarEnds far_ends = FarEnds::Modified;
    std::vector<End> ends;             ///< node after node, in file order
    std::vector<Joint> joints;         ///< in file order
    std::vector<MemberAction> members; ///< parallel to Model::members
    Loading loading;                   ///< joints locked, props in place
    std::vector<Sway> sways;           ///< independent of one another
    std::vector<GroundSpring> springs;
    std::vector<Eigen::Vector2d> imposed;    ///< displacement of every node that settlements and heat impose
    std::vector<Eigen::Vector2d> node_force; ///< on every node: from outside and from overhangs

    /// Extent::Half: what each sheet is worked on, that of the loads first, then of each sway. Ends that cross the axis
    /// have another stiffness there; sways, springs and node forces are left to the whole.
    std::vector<Problem> halves;
    std::optional<Mirror> mirror; ///< of such a half

    const Problem& of_sheet(std::size_t stage) const { return stage < halves.size() ? halves[stage] : *this; }
    bool is_balanced(JointId joint) const; ///< here, or on any of the halves
    bool is_on_sheet(EndId end) const { return !mirror || mirror->is_on_sheet[end.index]; }
    std::vector<JointId> balanced_joints() const; ///< in file order
    /// The joint whose balance turns this one: itself, or its mirror image. Nothing where it never turns.
    std::optional<JointId> balanced_for(JointId joint) const;

    const End& operator[](EndId id) const { return ends[id.index]; }
    const Joint& operator[](JointId id) const { return joints[id.index]; }
    std::optional<JointId> joint_at(NodeId node) const;
    std::optional<EndId> find_end(std::string_view label) const;
};

/// The largest structure that a sheet is made for.
inline constexpr std::size_t most_nodes = 1000;

/// \throws ModelError      what `check` finds; what the method cannot do: other models than frame2d, rigid members,
///                         offsets across the axis, springs along it, a joint without stiffness, changes of length
///                         and settlements that axially rigid members cannot follow
///                         and with Extent::Half what is not symmetric
Problem problem_of(const Model& model, CaseId load_case, FarEnds far_ends = FarEnds::Modified,
                   Extent extent = Extent::Whole);

/// The same with every member inextensible: what the method solves exactly.
Model inextensible_copy(const Model& model);

/// Names of the joints that are balanced, in file order.
std::vector<std::string> joint_names(const Model& model, const Problem& problem);

/// "4EI/L", "3EI/L", "2EI/L", "6EI/L", "0", else "".
std::string_view formula(const Problem& problem, EndId end);

} // namespace femoop::cross
