#include "apps/frame/view/geometry/structure_shape.h"

#include "femoop/model/member_axes.h"

namespace frame {

namespace {

using Eigen::Vector3d;

Vector3d vector_of(const std::vector<femoop::Quantity>& numbers)
{
    Vector3d v = Vector3d::Zero();
    for (std::size_t i = 0; i < numbers.size() && i < 3; ++i) v[static_cast<int>(i)] = numbers[i];
    return v;
}

MemberShape shape_of(const femoop::Model& model, const femoop::Member& member, const std::vector<Vector3d>& nodes)
{
    MemberShape shape;
    shape.start_node = nodes[member.nodes[0].index];
    shape.end_node = nodes[member.nodes[1].index];
    shape.start = shape.start_node + vector_of(member.start.offset);
    shape.end = shape.end_node + vector_of(member.end.offset);
    const Vector3d along = shape.end - shape.start;
    shape.length = along.norm();
    const Vector3d x = shape.length > 0.0 ? Vector3d(along / shape.length) : Vector3d::UnitX();
    shape.axes = femoop::member_axes(model.analysis, x, vector_of(member.up));
    return shape;
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
    for (const femoop::Node& node : model.nodes) shape.nodes.emplace_back(node.at[0], node.at[1], node.at[2]);
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

} // namespace frame
