#include "ui/paint/wrapped_lines.h"

#include <algorithm>

namespace ui {

namespace {

/// A dot between two parts of a line, which stays with the part before it.
bool begins_with_separator(std::string_view text)
{
    constexpr std::string_view dot = "·";
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    return text.starts_with(dot) && (text.size() == dot.size() || text[dot.size()] == ' ');
}

} // namespace

std::vector<std::string> wrapped_lines(const Fonts& fonts, std::string_view text, const TextStyle& style, double width)
{
    const auto word_end = [&](std::size_t from) {
        std::size_t end = from;
        do end = std::min(text.find(' ', text.find_first_not_of(' ', end)), text.size());
        while (begins_with_separator(text.substr(end)));
        return end;
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
