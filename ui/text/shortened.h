#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "ui/text/catalogue.h"

namespace ui {

/// The text, cut to its first letters and "…" where it has more than `most`. \pre UTF-8, most > 0
std::string shortened(std::string_view utf8, std::size_t most);
/// So many lines of the text at most, and a further one that counts the rest.
std::string first_lines(const std::string& text, std::size_t most, const Catalogue& tr);

} // namespace ui
