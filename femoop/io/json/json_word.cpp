#include "femoop/io/json/json_word.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

#include "femoop/model/quantity/number_text.h"

namespace femoop {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string_view taken_digits(std::string_view& text)
{
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    return digits;
}

bool take(std::string_view& text, std::string_view any_of)
{
    const bool is_there = !text.empty() && any_of.find(text.front()) != std::string_view::npos;
    if (is_there) text.remove_prefix(1);
    return is_there;
}

std::optional<std::string> from_hexadecimal(std::string_view digits)
{
    std::uint64_t number = 0;
    const char* const end = digits.data() + digits.size();
    const auto result = std::from_chars(digits.data(), end, number, 16);
    if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
    return std::to_string(number);
}

/// Takes a decimal number off the front of `text` and writes it as JSON does.
std::optional<std::string> taken_number(std::string_view& text)
{
    const bool is_negative = !text.empty() && text.front() == '-';
    take(text, "+-");
    std::string_view whole = taken_digits(text);
    std::string_view fraction;
    if (take(text, ".")) fraction = taken_digits(text);
    if (whole.empty() && fraction.empty()) return std::nullopt;
    whole.remove_prefix(std::min(whole.find_first_not_of('0'), whole.size()));
    std::string number = (is_negative ? "-" : "") + std::string(whole.empty() ? "0" : whole);
    if (!fraction.empty()) number += '.' + std::string(fraction);
    std::string_view exponent = text;
    if (!take(exponent, "eE")) return number;
    const bool is_small = !exponent.empty() && exponent.front() == '-';
    take(exponent, "+-");
    const std::string_view power = taken_digits(exponent);
    if (power.empty()) return number;
    text = exponent;
    return number + (is_small ? "e-" : "e") + std::string(power);
}

} // namespace

std::optional<std::string> json_spelling(std::string_view word)
{
    std::string plain = with_hyphen(word).value_or(std::string(word));
    std::transform(plain.begin(), plain.end(), plain.begin(), lower_case);
    for (const std::string_view known : {"true", "false", "null"})
        if (plain == known) return plain;
    if (plain.starts_with("0x")) return from_hexadecimal(std::string_view(plain).substr(2));
    plain.erase(std::remove(plain.begin(), plain.end(), '_'), plain.end());
    std::string_view rest = plain;
    auto number = taken_number(rest);
    return rest.empty() ? number : std::nullopt;
}

bool is_bare_quantity(std::string_view words)
{
    if (!taken_number(words)) return false;
    take(words, " ");
    return !words.empty() && is_letter(words.front()) && lower_case(words.front()) != 'e'; // 1e lacks its power
}

} // namespace femoop
