#pragma once

#include <vector>

#include "femoop/methods/mohr/plane_state.h"

namespace femoop::mohr {

/// States that a point goes through, one after the other; between two of them every component changes in proportion.
using LoadingPath = std::vector<PlaneState>;

/// The state at `t` from 0 (the first) to 1 (the last), each stretch taking as long as the others.
/// \pre the path is not empty; t is taken into its range
PlaneState state_on(const LoadingPath& path, double t);

/// The stress path: the highest point of every circle on the way (s = (s1 + s2)/2, t = (s1 - s2)/2), `n` to a stretch.
/// Source  [LambeWhitman1969], stress paths
std::vector<CirclePoint> stress_path(const LoadingPath& path, std::size_t n);

} // namespace femoop::mohr
