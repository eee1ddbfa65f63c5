#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "ui/text/catalogue.h"

namespace ui {

/// The text, cut to its first letters and "…" where it has more than `most`. \pre UTF-8, most > 0
std::string shortened(std::string_view utf8, std::size_t most);
/// The text, or the longest of its beginnings of at least so many letters, with "…", that fits; empty where none does.
std::string shortened_to_fit(std::string_view utf8, std::size_t least,
                             const std::function<bool(const std::string&)>& fits);
/// So many lines of the text at most, and a further one that counts the rest.
std::string first_lines(const std::string& text, std::size_t most, const Catalogue& tr);

} // namespace ui
