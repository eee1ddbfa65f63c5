#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/model/model.h"

namespace femoop {

/// Numbers of an offset or of `up` as a vector; what is not given is 0.
Eigen::Vector3d vector_of(const std::vector<Quantity>& numbers);

Eigen::Vector3d position_of(const Model& model, NodeId node); ///< z is 0 in a plane model

} // namespace femoop
