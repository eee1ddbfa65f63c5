#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace femoop {

/// The candidate that `typed` was probably meant to be: the fewest insertions, deletions, replacements and swaps of
/// neighbours, letter case aside; nothing if even the nearest is too far.
std::optional<std::string> nearest(std::string_view typed, const std::vector<std::string_view>& candidates);

} // namespace femoop
