#pragma once

#include <string>

#include "apps/mohr/document/document.h"

namespace mohr {

/// How a subject's components are called in pictures and panels.
struct Names {
    std::string normal; ///< "σ", "ε", "I"
    std::string shear;  ///< "τ", "γ/2", "−Ixy"
    std::string first, second, third;
};
Names names_of(Subject subject);

/// A unit as it is printed: "cm⁴" for "cm^4", "kN·m" for "kN*m".
std::string printed_unit(const std::string& unit);
/// Its square or cube: "MPa²", "(N/mm²)³".
std::string unit_power(const std::string& unit, int power);

/// "50 MPa"; the number alone where there is no unit.
std::string with_unit(const std::string& number, const std::string& unit);

} // namespace mohr
