#pragma once

#include <numbers>

inline constexpr double degree = std::numbers::pi / 180.0; ///< [rad]
