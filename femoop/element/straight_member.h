#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "femoop/element/element.h"
#include "femoop/element/internal_mechanism.h"
#include "femoop/element/member_properties.h"
#include "femoop/geometry/member_geometry.h"

namespace femoop {

/// What a member element is made of, in numbers that somebody else keeps.
struct MemberData {
    std::array<NodeId, 2> nodes;
    std::array<const Eigen::Vector3d*, 2> positions{}; ///< of its nodes
    const MemberProperties* properties = nullptr;
    const MemberEndConditions* end_conditions = nullptr; ///< nullptr: rigid joints, no offset, no constraint
    const Eigen::Vector3d* up = nullptr;                 ///< which way y' points; nullptr where the default holds
    std::uint32_t stiffness_group = 0;
};

MemberGeometry geometry_of(AnalysisKind kind, const MemberData& member);

/// A straight member as an element. Its degrees of freedom are those of its two nodes; where a constraint takes strains
/// from it, each end behind a joint that is not rigid has degrees of freedom of its own, the member-end ones, in the
/// member's axes:
///
///      u = (node 1, node 2, free axes of end 1, free axes of end 2)
///
/// Everywhere else the joints are condensed. Matrices are along global axes, over these degrees of freedom.
class StraightMember : public Element {
public:
    using Element::Element;

    virtual bool is_constrained() const = 0; ///< inextensible or rigid

    /// What a constraint imposes: C u = strain x imposed strain + curvature x imposed curvature.
    ///
    ///      u2 - u1 = strain L        and if rigid    phi2 - phi1 = curvature L,  v2 - v1 - L phi1 = curvature L^2 / 2
    struct ConstraintRows {
        Eigen::MatrixXd C; ///< [rows x dofs]
        Eigen::VectorXd strain, curvature;
    };
    virtual ConstraintRows constraint_rows() const = 0; ///< \pre is_constrained

    /// Stiffness [dofs x dofs] of what the constraint takes from the member. \pre is_constrained
    virtual Eigen::MatrixXd constrained_stiffness() const = 0;
    virtual PreciseMatrix precise_constrained_stiffness() const = 0;

    /// A' A of its strains as its nodes feel them [dofs of nodes, both ways], whether stiffness or constraint resists.
    virtual Eigen::MatrixXd resistance() const = 0;

    /// How its chord swings, and lengthens in parts of its length [3 x dofs of nodes], along x' y' z'.
    virtual Eigen::MatrixXd chord_rotations() const = 0;

    /// Motions of the member alone between releases that hold it nowhere.
    virtual std::vector<InternalMechanism> internal_mechanisms() const = 0;

    /// Its free twist, if these loads do work on it.
    virtual std::optional<InternalMechanism> loaded_twist(std::span<const SpanLoad> loads) const = 0;
};

/// The members of a structure in one block of memory, in order.
class MemberBlock {
public:
    virtual ~MemberBlock() = default;
    virtual std::size_t size() const = 0;
    virtual const StraightMember& operator[](std::size_t i) const = 0;
};

/// Member elements of one of the five models: the only place that tells the models apart. They are asked for in order;
/// what the data points to must outlive them.
std::unique_ptr<const MemberBlock> make_members(AnalysisKind kind, std::size_t n,
                                                const std::function<MemberData(std::size_t)>& data);

} // namespace femoop
