#include "femoop/model/quantity/unit_signs.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace femoop {

namespace {

struct Sign {
    std::string_view printed, in_file;
};

// The longer one first of two that begin alike.
constexpr std::array<Sign, 8> signs{{{"\u00b7", "*"},
                                     {"\u22c5", "*"},
                                     {"\u00b2", "^2"},
                                     {"\u00b3", "^3"},
                                     {"\u2074", "^4"},
                                     {"\u00b0C", "degC"},
                                     {"\u00b0F", "degF"},
                                     {"\u00b0", "deg"}}};

} // namespace

std::string with_file_signs(std::string_view printed)
{
    std::string text;
    for (std::size_t i = 0; i < printed.size();) {
        const auto sign = std::ranges::find_if(signs,
                                               [&](const Sign& s) { return printed.substr(i).starts_with(s.printed); });
        if (sign == signs.end()) {
            text += printed[i++];
            continue;
        }
        text += sign->in_file;
        i += sign->printed.size();
    }
    return text;
}

std::string with_product_dots(std::string_view in_file)
{
    std::string text;
    for (const char c : in_file) text += c == '*' ? std::string(signs.front().printed) : std::string(1, c);
    return text;
}

std::string printed_unit(Dimension dimension, const Units& units)
{
    return with_product_dots(unit_text(dimension, units));
}

} // namespace femoop
