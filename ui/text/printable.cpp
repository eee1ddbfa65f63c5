#include "ui/text/printable.h"

#include <algorithm>
#include <cstddef>

namespace ui {

namespace {

constexpr unsigned char delete_sign = 0x7F, first_beyond = 0xC2; // of the two bytes of U+0080 to U+009F

unsigned char code(char c) { return static_cast<unsigned char>(c); }

bool is_control(char c) { return (code(c) < 0x20U && c != '\n' && c != '\t' && c != '\r') || code(c) == delete_sign; }

bool is_control_beyond(const std::string& text, std::size_t i)
{
    return code(text[i]) == first_beyond && i + 1 < text.size() && code(text[i + 1]) >= 0x80U &&
           code(text[i + 1]) < 0xA0U;
}

std::string escaped(char control)
{
    constexpr const char* digits = "0123456789abcdef";
    return {'\\', 'u', '0', '0', digits[code(control) / 16U], digits[code(control) % 16U]};
}

} // namespace

std::string printable(std::string text)
{
    const auto may_be_control = [](char c) { return is_control(c) || code(c) == first_beyond; };
    if (std::none_of(text.begin(), text.end(), may_be_control)) return text;
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (is_control_beyond(text, i)) shown += escaped(text[++i]);
        else if (is_control(text[i])) shown += escaped(text[i]);
        else shown += text[i];
    }
    return shown;
}

} // namespace ui
