#pragma once

#include <optional>
#include <string>

namespace femoop::cross {

/// A number as a fraction in its lowest terms.
struct Fraction {
    long numerator = 0, denominator = 1;
    friend bool operator==(const Fraction&, const Fraction&) = default;
};

/// The fraction that a number is, if it is a simple one: 0.428571428571... is 3/7. Nothing for others.
/// Accuracy  to 1e-12 of the number, by its continued fraction
std::optional<Fraction> fraction_of(double value, long largest_denominator = 9999);

std::string fraction_text(const Fraction& fraction); ///< "3/7", "2"

} // namespace femoop::cross
