#include "ui/paint/wrapped_lines.h"

#include <algorithm>
#include <optional>

namespace ui {

namespace {

/// A dot between two parts of a line, which stays with the part before it.
bool begins_with_separator(std::string_view text)
{
    constexpr std::string_view dot = "·";
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    return text.starts_with(dot) && (text.size() == dot.size() || text[dot.size()] == ' ');
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string_view last_word(std::string_view text) { return text.substr(text.rfind(' ') + 1); }

/// "(3.2," of a place, before its other coordinate.
bool is_first_coordinate(std::string_view word)
{
    return word.starts_with('(') && (word.back() == ',' || word.back() == ';');
}
/// "M" in "N = 0, M = 3", before the second sign.
bool is_name_of_value(std::string_view before, std::string_view word)
{
    constexpr std::size_t longest = 4; // "ΣM"
    const std::size_t begin = before.find_last_of(",;:") + 1;
    return begin > 0 && word.size() <= longest && !is_digit(word.back()) &&
           before.find('=', begin) == std::string_view::npos;
}
bool begins_with_number(std::string_view text) { return is_digit(text.front()) || text.starts_with("−"); }

/// Belong the parts of a line before and after a space together: a number and its unit, a sign and its term, a name and
/// what it is equal to, the coordinates of a place?
bool belong_together(std::string_view before, std::string_view after)
{
    if (!after.starts_with(' ') || after.size() < 2) return false;
    const std::string_view word = last_word(before);
    if (word.empty()) return false;
    if (word == "+" || word == "−" || word == "=") return true;
    if (after.starts_with(" = ")) return is_name_of_value(before, word);
    if (word == "·" || is_first_coordinate(word)) return begins_with_number(after.substr(1));
    return begins_with_number(word) && is_digit(word.back()) && is_letter(after[1]);
}

} // namespace

std::vector<std::string> wrapped_lines(const Fonts& fonts, std::string_view text, const TextStyle& style, double width)
{
    const auto word_end = [&](std::size_t from) {
        std::size_t end = from;
        do end = std::min(text.find(' ', text.find_first_not_of(' ', end)), text.size());
        while (begins_with_separator(text.substr(end)) || belong_together(text.substr(0, end), text.substr(end)));
        return end;
    };
    // an equation among the parts of a line stays whole where the line is not much shorter by that
    const auto end_before_equation = [&](std::size_t line_end) -> std::optional<std::size_t> {
        constexpr std::string_view dot = " ·  ";
        constexpr double least = 0.5;
        const std::size_t last = text.substr(0, line_end).rfind(dot);
        if (last == std::string_view::npos) return std::nullopt;
        const std::size_t end = last + dot.size() - 2;
        const std::string_view part = text.substr(end, text.find(dot, end) - end);
        const bool is_equation = part.find(" = ") != std::string_view::npos;
        if (!is_equation || fonts.measure(text.substr(0, end), style).width < least * width) return std::nullopt;
        return end;
    };
    const auto fits = [&](std::string_view line) { return fonts.measure(line, style).width <= width; };
    std::vector<std::string> lines;
    while (text.find_first_not_of(' ') != std::string_view::npos) {
        text.remove_prefix(text.find_first_not_of(' '));
        std::size_t end = word_end(0);
        while (end < text.size() && fits(text.substr(0, word_end(end)))) end = word_end(end);
        if (end < text.size()) end = end_before_equation(end).value_or(end);
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return lines;
}

} // namespace ui
