#pragma once

#include <string_view>
#include <vector>

namespace ui {

/// The text of each file of ui/text/pt_BR/, put into the program by ui/text/embed.cmake.
std::vector<std::string_view> compiled_portuguese();

} // namespace ui
