#pragma once

#include <optional>
#include <vector>

#include "femoop/discretisation/solution.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop {

inline constexpr double largest_number = 1e250; ///< a few lengths, multiplied with it, are still numbers

/// The load cases and combinations of which some displacement, reaction or section force is beyond the range of
/// numbers.
///
/// Time  one look at every number that goes in; members are gone through only if those are so large or so small that
///       their products might overflow
std::vector<Fault> overflowing_cases(const detail::Solution& solution, const Results& results);

/// The first node that moves further than `most` times the structure's size, in the first load case where one does.
std::optional<Fault> huge_displacement(const Model& model, const Discretisation& structure, const Results& results,
                                       double most);

} // namespace femoop
