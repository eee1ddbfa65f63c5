#pragma once

#include <Eigen/Core>

#include "femoop/model/dof.h"

namespace femoop {

/// The axes of a member as rows x', y', z', by the rule of `Member`. Defined for a faulty `up` too, one along the
/// member: then the default holds.
/// \param x   unit vector along the member
/// \param up  which way y' points in space; zero where the model says nothing
Eigen::Matrix3d member_axes(AnalysisKind kind, const Eigen::Vector3d& x, const Eigen::Vector3d& up);

} // namespace femoop
