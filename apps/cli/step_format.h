#pragma once

#include <cstdint>

namespace cli {

/// As what an explanation is printed.
enum class StepFormat : std::uint8_t { Text, Json, Latex };

} // namespace cli
