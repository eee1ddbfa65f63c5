#pragma once

#include <Eigen/Core>

namespace femoop {

/// The cross product of two plane vectors: positive where the second is counter-clockwise of the first.
inline double cross_product(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace femoop
