#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "femoop/discretisation/solution.h"

namespace femoop::detail {

/// A vector [6] at each end of a member, along and about its own axes.
using EndVectors = std::array<Eigen::Matrix<double, 6, 1>, 2>;

/// Displacements of a member's own two ends, through rigid arms and flexible joints.
EndVectors end_displacements(const Solution& solution, std::size_t case_index, MemberId member);

/// Forces on a member's own two ends: what its nodes do to it.
EndVectors end_forces(const Solution& solution, std::size_t case_index, MemberId member);

} // namespace femoop::detail
