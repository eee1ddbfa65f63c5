#include "femoop/methods/cross/fraction.h"

#include <cmath>

namespace femoop::cross {

namespace {

constexpr double same = 1e-12; // of the number
constexpr double largest_number = 1e9;

} // namespace

std::optional<Fraction> fraction_of(double value, long largest_denominator)
{
    if (!(std::abs(value) < largest_number)) return std::nullopt;
    Fraction before{1, 0}, now{std::lround(std::floor(value)), 1};
    double rest = value - std::floor(value);
    while (std::abs(static_cast<double>(now.numerator) / static_cast<double>(now.denominator) - value) >
           same * std::abs(value)) {
        const double inverse = 1.0 / rest;
        if (!(inverse < largest_number)) return std::nullopt;
        const long whole = std::lround(std::floor(inverse));
        const Fraction next{whole * now.numerator + before.numerator, whole * now.denominator + before.denominator};
        if (next.denominator > largest_denominator) return std::nullopt;
        before = now;
        now = next;
        rest = inverse - std::floor(inverse);
    }
    return now;
}

std::string fraction_text(const Fraction& fraction)
{
    const std::string numerator = std::to_string(fraction.numerator);
    return fraction.denominator == 1 ? numerator : numerator + "/" + std::to_string(fraction.denominator);
}

} // namespace femoop::cross
