#pragma once

#include <string_view>
#include <vector>

namespace plane {

/// The models of examples/ that apps/plane/document/CMakeLists.txt lists, put into the program by ui/text/embed.cmake.
std::vector<std::string_view> compiled_models();

} // namespace plane
