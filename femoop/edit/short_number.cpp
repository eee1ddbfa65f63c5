#include "femoop/edit/short_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace femoop {

namespace {

double rounded(double value, int n_digits)
{
    std::array<char, 32> text{};
    const auto written = std::to_chars(text.begin(), text.end(), value, std::chars_format::scientific, n_digits - 1);
    double read = value;
    std::from_chars(text.begin(), written.ptr, read);
    return read;
}

} // namespace

double short_number(double value, double scale)
{
    constexpr int most_digits = 12;
    constexpr double n_roundings = 16.0;
    if (!std::isfinite(value)) return value;
    const double slack = n_roundings * std::numeric_limits<double>::epsilon() *
                         std::max(std::abs(scale), std::abs(value));
    if (std::abs(value) <= slack) return 0.0;
    for (int n_digits = 1; n_digits <= most_digits; ++n_digits)
        if (const double shorter = rounded(value, n_digits); std::abs(shorter - value) <= slack) return shorter;
    return value;
}

} // namespace femoop
