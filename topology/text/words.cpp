#include "topology/text/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace topology {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

} // namespace

Lines::Lines(std::string_view text) : rest_(text)
{
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

bool Lines::next()
{
    if (rest_.empty()) return false;
    line_ = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(line_.size() + 1, rest_.size()));
    ++number_;
    return true;
}

std::vector<std::string_view> words(std::string_view line)
{
    std::vector<std::string_view> found;
    std::size_t at = 0;
    while (true) {
        while (at < line.size() && is_blank(line[at])) ++at;
        if (at == line.size() || line[at] == '#') return found;
        const std::size_t begin = at;
        while (at < line.size() && !is_blank(line[at])) ++at;
        found.push_back(line.substr(begin, at - begin));
    }
}

std::optional<double> finite_number(std::string_view word)
{
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double value = 0.0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool is_whole_word = result.ec == std::errc() && result.ptr == digits.data() + digits.size();
    if (!is_whole_word || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string written(double value)
{
    std::array<char, 32> text{};
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), result.ptr};
}

} // namespace topology
