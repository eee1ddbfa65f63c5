#pragma once

#include <Eigen/Core>
#include <array>

#include "femoop/geometry/node_position.h"
#include "femoop/model/model.h"

namespace femoop {

/// Where a member lies: the ends of its flexible part, between its rigid offsets, and its own axes there.
///
///      node o====o--------------------o====o node
///           arm  start -> x'        end  arm
///
/// Of a member without length x' is along the global x.
struct MemberGeometry {
    Eigen::Matrix3d axes;       ///< rows x' y' z' in global axes
    Eigen::Vector3d start, end; ///< of the flexible part
    double length = 0.0;        ///< of the flexible part

    Eigen::Vector3d at(double x) const { return start + x * axes.row(0).transpose(); } ///< x in 0 .. length
};

/// \param up  which way y' points in space; zero where the model says nothing (femoop/geometry/member_axes.h)
MemberGeometry member_geometry(AnalysisKind kind, const Eigen::Vector3d& start, const Eigen::Vector3d& end,
                               const Eigen::Vector3d& up);

MemberGeometry geometry_of(const Model& model, const Member& member);
/// The ends of its flexible part alone.
std::array<Eigen::Vector3d, 2> ends_of(const Model& model, const Member& member);

} // namespace femoop
