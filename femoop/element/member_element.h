#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "femoop/element/analysis_model.h"
#include "femoop/element/internal_mechanism.h"
#include "femoop/element/joint_condensation.h"
#include "femoop/element/member_properties.h"
#include "femoop/element/span_load.h"
#include "femoop/element/strain_form.h"
#include "femoop/geometry/member_geometry.h"

namespace femoop {

/// The ways in which a straight member resists, each on its own: what is stiffness, what is constraint.
enum class Action : std::uint8_t {
    Axial = 1,
    Torsion = 2,
    BendingXY = 4,
    BendingXZ = 8,
    RigidOnFoundation = 16 ///< a rigid member's foundation: all that is left of its bending
};

class ActionSet {
public:
    constexpr ActionSet() = default;
    constexpr ActionSet(std::initializer_list<Action> actions)
    {
        for (const Action action : actions) bits_ |= static_cast<unsigned>(action);
    }
    constexpr bool contains(Action action) const { return (bits_ & static_cast<unsigned>(action)) != 0; }

private:
    unsigned bits_ = 0;
};

inline constexpr ActionSet all_actions{Action::Axial, Action::Torsion, Action::BendingXY, Action::BendingXZ};

/// What strains this member, and what its constraint takes away.
ActionSet elastic_actions(const MemberEndConditions& end_conditions);
ActionSet constrained_actions(const MemberEndConditions& end_conditions);

/// A straight member of one of the five models, from its own axes to the degrees of freedom of its two nodes.
///
///           y'
///      1 o--|--> x' -----------o 2     d = (end 1, end 2), each with the model's local displacements
///
/// Signs    nodal forces act on the member, along + local or global axes
/// Assumes  what Bar and Beam assume; trusses and bars carry span loads to their nodes as simple beams
/// Source   [McGuireGallagherZiemian2000, ch. 4-5]
template <AnalysisKind kind> class MemberElement {
public:
    static constexpr int m = static_cast<int>(AnalysisModel<kind>::local.size());  ///< local displacements of an end
    static constexpr int n = static_cast<int>(AnalysisModel<kind>::global.size()); ///< degrees of freedom of a node
    using LocalMatrix = Eigen::Matrix<double, 2 * m, 2 * m>;
    using LocalVector = Eigen::Matrix<double, 2 * m, 1>;
    using Transformation = Eigen::Matrix<double, m, n>;
    using GlobalMatrix = Eigen::Matrix<double, 2 * n, 2 * n>;
    using GlobalVector = Eigen::Matrix<double, 2 * n, 1>;

    MemberElement(const MemberProperties& properties, const MemberGeometry& geometry,
                  const MemberEndConditions* end_conditions, ActionSet actions = all_actions);

    /// Stiffness in the member's axes with rigid joints.
    LocalMatrix rigid_joint_stiffness() const;
    /// Fixed-end forces in the member's axes with rigid joints.
    LocalVector rigid_joint_forces(const SpanLoading& loading) const;

    /// The same with releases and springs condensed.
    LocalMatrix local_stiffness() const;
    LocalVector local_fixed_end_forces(const SpanLoading& loading) const;

    /// What strains the member, from the displacements of its ends in its axes: angles, and lengths counted in its own
    /// length; B is all zero for motions that its stiffness does not feel, whatever the stiffness is. B' S B is the
    /// stiffness, which loses nothing when displacements are large beside their differences.
    StrainForm rigid_joint_strains() const;
    StrainForm strains() const; ///< of its nodes, with releases and springs

    /// What the nodes feel, along global axes.
    GlobalMatrix stiffness() const;
    GlobalVector fixed_end_forces(const SpanLoading& loading) const;
    /// The part of them that a truss member or a bar carries as a simple beam across its axis.
    GlobalVector simple_span_forces(const SpanLoading& loading) const;

    /// The member's own end displacements, and the forces on its ends, from the displacements of its nodes, all in its
    /// axes, through flexible joints.
    LocalVector end_displacements(const LocalVector& nodes, const LocalVector& rigid_joint_forces) const;
    LocalVector end_forces(const LocalVector& nodes, const LocalVector& rigid_joint_forces) const;

    /// Motions of the member alone between releases that hold it nowhere.
    std::vector<InternalMechanism> internal_mechanisms(
        const LocalVector& rigid_joint_forces = LocalVector::Zero()) const;

    /// Displacements of an end, in the member's axes, from those of its node: local = T node, rigid arms included.
    Transformation transformation(std::size_t end) const;
    /// The same for one axis of the member, also for one that it does not resist along.
    Eigen::Matrix<double, 1, n> transformation_row(std::size_t end, LocalAxis axis) const;

private:
    Beam own_beam(BendingPlane plane) const;
    bool has_flexible_joint() const { return end_conditions_ != nullptr && end_conditions_->has_flexible_joint; }
    /// One way in which the member resists; the ways do not feel one another.
    struct ActionForm {
        std::vector<int> rows; ///< of the member's displacements
        StrainForm form;
        double unit; ///< of its strains: 1 where they are angles, else the member's length
    };
    std::vector<ActionForm> action_forms() const;
    /// The same between flexible joints.
    struct JointedAction {
        std::vector<int> rows;
        JointCondensation condensation;
    };
    std::vector<JointedAction> jointed_actions() const;
    template <class FormOf> StrainForm gathered_strains(FormOf&& form_of) const;
    LocalVector joint_stiffness() const;
    GlobalVector to_nodes(const LocalVector& local) const;

    const MemberProperties& properties_;
    const MemberEndConditions* end_conditions_;
    const MemberGeometry& geometry_;
    ActionSet actions_;
};

} // namespace femoop
