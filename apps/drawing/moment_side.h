#pragma once

#include <cstdint>

namespace drawing {

/// Where a positive bending moment is drawn: on the side that it stretches, or on the other one.
enum class MomentSide : std::uint8_t { Tension, Compression };

} // namespace drawing
