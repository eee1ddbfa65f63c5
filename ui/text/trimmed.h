#pragma once

#include <string_view>

namespace ui {

/// Without the blanks, tabs and line ends before and after it.
constexpr std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

} // namespace ui
