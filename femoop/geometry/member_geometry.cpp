#include "femoop/geometry/member_geometry.h"

#include "femoop/geometry/member_axes.h"

namespace femoop {

MemberGeometry member_geometry(AnalysisKind kind, const Eigen::Vector3d& start, const Eigen::Vector3d& end,
                               const Eigen::Vector3d& up)
{
    MemberGeometry geometry{.axes = {}, .start = start, .end = end};
    const Eigen::Vector3d along = end - start;
    geometry.length = along.norm();
    const bool has_length = geometry.length > 0.0;
    const Eigen::Vector3d x = has_length ? Eigen::Vector3d(along / geometry.length) : Eigen::Vector3d::UnitX();
    geometry.axes = member_axes(kind, x, up);
    return geometry;
}

std::array<Eigen::Vector3d, 2> ends_of(const Model& model, const Member& member)
{
    return {position_of(model, member.nodes[0]) + vector_of(member.start.offset),
            position_of(model, member.nodes[1]) + vector_of(member.end.offset)};
}

MemberGeometry geometry_of(const Model& model, const Member& member)
{
    const auto [start, end] = ends_of(model, member);
    return member_geometry(model.analysis, start, end, vector_of(member.up));
}

} // namespace femoop
