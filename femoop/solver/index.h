#pragma once

#include <cstddef>
#include <cstdint>

namespace femoop {

/// The number of a block, an equation or a front, as an index.
constexpr std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

} // namespace femoop
