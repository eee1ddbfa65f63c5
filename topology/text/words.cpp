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

namespace {

/// How many bytes follow a first one, and the least and the greatest that the next may be; none of a byte that begins
/// nothing. Overlong forms, surrogates and numbers beyond U+10FFFF are left out so.
struct Following {
    std::size_t n = 0;
    unsigned char least = 0x80, most = 0xBF;
};
std::optional<Following> following(unsigned char first)
{
    if (first < 0x80U) return Following{};
    if (first >= 0xC2U && first <= 0xDFU) return Following{.n = 1};
    if (first == 0xE0U) return Following{.n = 2, .least = 0xA0};
    if (first == 0xEDU) return Following{.n = 2, .most = 0x9F};
    if (first >= 0xE1U && first <= 0xEFU) return Following{.n = 2};
    if (first == 0xF0U) return Following{.n = 3, .least = 0x90};
    if (first == 0xF4U) return Following{.n = 3, .most = 0x8F};
    if (first >= 0xF1U && first <= 0xF3U) return Following{.n = 3};
    return std::nullopt;
}

} // namespace

bool is_utf8(std::string_view word)
{
    while (!word.empty()) {
        const auto rest = following(static_cast<unsigned char>(word.front()));
        if (!rest || word.size() <= rest->n) return false;
        for (std::size_t i = 1; i <= rest->n; ++i) {
            const auto byte = static_cast<unsigned char>(word[i]);
            const bool is_second = i == 1;
            if (byte < (is_second ? rest->least : 0x80U) || byte > (is_second ? rest->most : 0xBFU)) return false;
        }
        word.remove_prefix(rest->n + 1);
    }
    return true;
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
