#include "ui/paint/wrapped_lines.h"

#include <algorithm>

namespace ui {

std::vector<std::string> wrapped_lines(const Fonts& fonts, std::string_view text, const TextStyle& style, double width)
{
    const auto word_end = [&](std::size_t from) {
        return std::min(text.find(' ', text.find_first_not_of(' ', from)), text.size());
    };
    const auto fits = [&](std::string_view line) { return fonts.measure(line, style).width <= width; };
    std::vector<std::string> lines;
    while (text.find_first_not_of(' ') != std::string_view::npos) {
        text.remove_prefix(text.find_first_not_of(' '));
        std::size_t end = word_end(0);
        while (end < text.size() && fits(text.substr(0, word_end(end)))) end = word_end(end);
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return lines;
}

} // namespace ui
