#pragma once

#include <string_view>
#include <vector>

namespace cross {

/// The model files that are built into the program, in the order in which CMakeLists.txt lists them.
std::vector<std::string_view> compiled_examples();

} // namespace cross
