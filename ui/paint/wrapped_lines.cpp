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

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string_view last_word(std::string_view text) { return text.substr(text.rfind(' ') + 1); }

/// Belong the parts of a line before and after a space together: a number and its unit, a sign and its term?
bool belong_together(std::string_view before, std::string_view after)
{
    if (!after.starts_with(' ') || after.size() < 2) return false;
    const std::string_view word = last_word(before);
    if (word.empty()) return false;
    if (word == "+" || word == "−" || word == "=") return true;
    if (word == "·") return is_digit(after[1]) || after.starts_with(" −");
    return (is_digit(word.front()) || word.starts_with("−")) && is_digit(word.back()) && is_letter(after[1]);
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
