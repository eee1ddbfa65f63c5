#include "femoop/geometry/member_axes.h"

#include <Eigen/Geometry>
#include <cmath>

namespace femoop {

namespace {

using Eigen::Vector3d;

Vector3d default_up(const Vector3d& x)
{
    const bool is_vertical = std::hypot(x.x(), x.y()) < 1e-9;
    return is_vertical ? Vector3d::UnitY() : Vector3d::UnitZ();
}

Vector3d square_part(const Vector3d& v, const Vector3d& x) { return v - v.dot(x) * x; }

} // namespace

Eigen::Matrix3d member_axes(AnalysisKind kind, const Vector3d& x, const Vector3d& up)
{
    Eigen::Matrix3d axes;
    axes.row(0) = x;
    if (is_plane(kind)) {
        axes.row(1) = Vector3d(-x.y(), x.x(), 0.0);
        axes.row(2) = Vector3d::UnitZ();
        return axes;
    }
    const bool has_up = square_part(up, x).norm() > 1e-9 * up.norm();
    const Vector3d y = square_part(has_up ? up : default_up(x), x).normalized();
    axes.row(1) = y;
    axes.row(2) = x.cross(y);
    return axes;
}

} // namespace femoop
