#include "ui/text/printable.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace ui {

namespace {

/// Characters that are not seen but act on what is, beyond those of one byte.
struct Range {
    char32_t first, last;
};
constexpr std::array<Range, 9> acting{{{0x80, 0x9F},         // controls
                                       {0xAD, 0xAD},         // a hyphen that may hide
                                       {0x61C, 0x61C},       // mark of Arabic direction
                                       {0x180E, 0x180E},     // separator of Mongolian vowels
                                       {0x200B, 0x200F},     // without width, marks of direction
                                       {0x2028, 0x202E},     // ends of lines and paragraphs, embeddings of direction
                                       {0x2060, 0x206F},     // joiners, isolates of direction
                                       {0xFEFF, 0xFEFF},     // byte-order mark
                                       {0xE0000, 0xE007F}}}; // tags

unsigned char code(char c) { return static_cast<unsigned char>(c); }

bool is_control(char c)
{
    constexpr unsigned char delete_sign = 0x7F;
    return (code(c) < 0x20U && c != '\n' && c != '\t' && c != '\r') || code(c) == delete_sign;
}

/// A character of two to four bytes that acts: its bytes at the beginning of the text are gone through.
struct Acting {
    char32_t character;
    std::size_t n_bytes;
};
std::optional<Acting> acting_at(std::string_view text)
{
    constexpr unsigned two_bytes = 0xC0, three_bytes = 0xE0, four_bytes = 0xF0, last_six = 0x3F;
    const unsigned lead = code(text.front());
    const std::size_t n = lead < two_bytes ? 0 : lead < three_bytes ? 2 : lead < four_bytes ? 3 : 4;
    if (n == 0 || text.size() < n) return std::nullopt;
    char32_t character = lead & (0x7FU >> n);
    for (std::size_t i = 1; i < n; ++i) character = character << 6U | (code(text[i]) & last_six);
    const bool acts = std::ranges::any_of(acting, [&](Range r) { return character >= r.first && character <= r.last; });
    return acts ? std::optional(Acting{character, n}) : std::nullopt;
}

std::string escaped(char32_t character)
{
    constexpr const char* digits = "0123456789abcdef";
    constexpr char32_t first_of_two = 0x10000, first_half = 0xD800, second_half = 0xDC00;
    if (character >= first_of_two) {
        const char32_t beyond = character - first_of_two;
        return escaped(first_half + (beyond >> 10U)) + escaped(second_half + (beyond & 0x3FFU));
    }
    std::string text = "\\u";
    for (const unsigned shift : {12U, 8U, 4U, 0U}) text += digits[character >> shift & 0xFU];
    return text;
}

} // namespace

std::string printable(std::string text)
{
    constexpr unsigned char beyond_ascii = 0x80;
    const auto may_act = [](char c) { return is_control(c) || code(c) >= beyond_ascii; };
    if (std::ranges::none_of(text, may_act)) return text;
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (const auto acts = acting_at(std::string_view(text).substr(i))) {
            shown += escaped(acts->character);
            i += acts->n_bytes - 1;
        } else if (is_control(text[i])) shown += escaped(code(text[i]));
        else shown += text[i];
    }
    return shown;
}

} // namespace ui
