#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "femoop/element/element.h"
#include "femoop/element/member_properties.h"
#include "femoop/element/straight_member.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/model/model.h"

namespace femoop {

/// A model as numbers: what the analysis needs of nodes and members, in dense arrays and consistent units.
/// Held by the results too, so that they outlive the model.
struct Discretisation {
    struct MemberRow {
        std::array<NodeId, 2> nodes;
        std::uint32_t properties = 0;     ///< index of Discretisation::properties
        std::int32_t end_conditions = -1; ///< index of Discretisation::end_conditions, or -1
    };
    struct SupportRow {
        NodeId node;
        DofSet blocked;
        NodeVector springs{};  ///< 0 where there is none
        double angle = 0.0;    ///< [rad]
        DofSet on_foundations; ///< displacements that elements of `foundations` resist
    };
    struct Tie {
        NodeId node;
        Dof dof = Dof::ux;
        NodeId leader; ///< whose displacement it has, global axes
    };

    AnalysisKind kind = AnalysisKind::Frame2d;
    std::vector<Eigen::Vector3d> positions;
    std::vector<MemberRow> members;
    std::vector<MemberProperties> properties;
    std::vector<MemberEndConditions> end_conditions;
    std::vector<Eigen::Vector3d> up; ///< parallel to end_conditions; zero where the default holds
    std::vector<SupportRow> supports;
    std::vector<std::int32_t> support_of_node;               ///< index of supports, or -1
    std::vector<bool> is_attached;                           ///< does any member meet the node?
    bool has_constraints = false;                            ///< any inextensible or rigid member
    std::vector<std::shared_ptr<const Element>> bodies;      ///< elements that are no members, such as those of a plate
    std::vector<std::shared_ptr<const Element>> foundations; ///< elements that are supports
    std::vector<Tie> ties;                                   ///< \pre of nodes whose axes are not turned

    MemberData data(MemberId member) const; ///< valid while this lives
    MemberGeometry geometry(MemberId member) const { return geometry_of(kind, data(member)); }
    double size() const; ///< diagonal of the box around the nodes; 0 without any
    const MemberProperties& properties_of(MemberId member) const
    {
        return properties[members[member.index].properties];
    }
    const MemberEndConditions* end_conditions_of(MemberId member) const
    {
        const std::int32_t at = members[member.index].end_conditions;
        return at < 0 ? nullptr : &end_conditions[static_cast<std::size_t>(at)];
    }
    const SupportRow* support_of(NodeId node) const
    {
        const std::int32_t at = support_of_node[node.index];
        return at < 0 ? nullptr : &supports[static_cast<std::size_t>(at)];
    }
};

Discretisation discretise(const Model& model);

} // namespace femoop
