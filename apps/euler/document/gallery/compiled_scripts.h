#pragma once

#include <string_view>
#include <vector>

namespace euler {

/// The scripts of examples/ that apps/euler/document/CMakeLists.txt lists, put into the program by ui/text/embed.cmake.
std::vector<std::string_view> compiled_scripts();

} // namespace euler
