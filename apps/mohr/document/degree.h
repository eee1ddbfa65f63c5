#pragma once

#include <numbers>

namespace mohr {

inline constexpr double degree = std::numbers::pi / 180.0; ///< [rad]

} // namespace mohr
