#pragma once

#include "femoop/geometry/member_geometry.h"
#include "femoop/model/model.h"

#include <Eigen/Core>
#include <vector>

namespace drawing {

/// Where a member lies, in the model's unit of length. Known of any model, solved or not; of a faulty one the length
/// may be 0.
struct MemberShape : femoop::MemberGeometry {
    Eigen::Vector3d start_node, end_node; ///< the nodes that it joins

    Eigen::Vector3d x() const { return axes.row(0); }
    Eigen::Vector3d y() const { return axes.row(1); }
    Eigen::Vector3d z() const { return axes.row(2); }
};

/// Places of all nodes and members: what a view needs before anything is solved.
struct StructureShape {
    std::vector<Eigen::Vector3d> nodes;
    std::vector<MemberShape> members;
    std::vector<std::vector<femoop::MemberId>> members_at; ///< of each node
    double size = 1.0; ///< diagonal of the box around all nodes, 1 where they lie at one place

    const Eigen::Vector3d& operator[](femoop::NodeId node) const { return nodes[node.index]; }
    const MemberShape& operator[](femoop::MemberId member) const { return members[member.index]; }
};

StructureShape shape_of(const femoop::Model& model);

/// Unit vector from the node into the member. \pre the member meets the node.
Eigen::Vector3d direction_from(const StructureShape& shape, const femoop::Model& model, femoop::NodeId node,
                               femoop::MemberId member);

} // namespace drawing
