#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ui {

/// The text, cut to its first letters and "…" where it has more than `most`. \pre UTF-8, most > 0
std::string shortened(std::string_view utf8, std::size_t most);

} // namespace ui
