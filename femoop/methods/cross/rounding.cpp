#include "femoop/methods/cross/rounding.h"

#include <array>
#include <charconv>

namespace femoop::cross {

double rounded(double value, int digits)
{
    if (digits <= 0 || digits > 16) return value;
    std::array<char, 40> text{};
    const auto written = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific,
                                       digits - 1);
    double read = value;
    std::from_chars(text.data(), written.ptr, read);
    return read;
}

} // namespace femoop::cross
