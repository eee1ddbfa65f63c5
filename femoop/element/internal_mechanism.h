#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "femoop/element/span_load.h"

namespace femoop {

/// An end displacement that a member's releases leave free of all strain.
struct InternalMechanism {
    std::size_t end;
    LocalAxis axis;
    std::array<Eigen::Matrix<double, 6, 1>, 2> mode; ///< motion of the member's ends, its own axes
    double work = 0.0;                               ///< of the loads on it, where loads were given
};

} // namespace femoop
