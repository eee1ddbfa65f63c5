#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace femoop {

/// A name that stands twice in a list: its place, and that of the first.
struct RepeatedName {
    std::size_t index = 0;
    std::size_t first = 0;
};

/// Every name that repeats an earlier one. Time grows with the number of names: a model may have millions.
std::vector<RepeatedName> repeated_names(const std::vector<std::string_view>& names);

} // namespace femoop
