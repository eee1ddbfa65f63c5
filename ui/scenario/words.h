#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ui {

/// The words of a text between blanks.
std::vector<std::string> words_of(std::string_view text);

/// Those from a place on, with one blank between two.
std::string joined(const std::vector<std::string>& words, std::size_t first);

/// The text without the quotation marks around it, where it has them.
std::string unquoted(std::string_view text);

} // namespace ui
