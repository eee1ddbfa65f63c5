#pragma once

namespace tabular {

/// A number to be rounded to ten digits at most, a trace larger in magnitude. What lies half way between two last digits
/// comes out of one calculation a bit below and out of another a bit above; so both are rounded away from zero, and equal
/// bars have equal numbers.
constexpr double off_half(double value)
{
    constexpr double trace = 1e-12; // far above rounding, far below a tenth digit
    return value * (1.0 + trace);
}

} // namespace tabular
