#include "apps/drawing/geometry/structure_shape.h"

namespace drawing {

namespace {

using Eigen::Vector3d;

MemberShape shape_of(const femoop::Model& model, const femoop::Member& member, const std::vector<Vector3d>& nodes)
{
    return {femoop::geometry_of(model, member), nodes[member.nodes[0].index], nodes[member.nodes[1].index]};
}

double diagonal(const std::vector<Vector3d>& nodes)
{
    if (nodes.empty()) return 1.0;
    Vector3d low = nodes.front();
    Vector3d high = nodes.front();
    for (const Vector3d& node : nodes) {
        low = low.cwiseMin(node);
        high = high.cwiseMax(node);
    }
    const double size = (high - low).norm();
    return size > 0.0 ? size : 1.0;
}

} // namespace

StructureShape shape_of(const femoop::Model& model)
{
    StructureShape shape;
    shape.nodes.reserve(model.nodes.size());
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        shape.nodes.push_back(femoop::position_of(model, femoop::NodeId{i}));
    shape.members_at.resize(model.nodes.size());
    shape.members.reserve(model.members.size());
    for (std::size_t i = 0; i < model.members.size(); ++i) {
        shape.members.push_back(shape_of(model, model.members[i], shape.nodes));
        for (const femoop::NodeId node : model.members[i].nodes)
            shape.members_at[node.index].push_back(femoop::MemberId{i});
    }
    shape.size = diagonal(shape.nodes);
    return shape;
}

Vector3d direction_from(const StructureShape& shape, const femoop::Model& model, femoop::NodeId node,
                        femoop::MemberId member)
{
    const MemberShape& m = shape[member];
    return model[member].nodes[0] == node ? m.x() : Vector3d(-m.x());
}

} // namespace drawing
