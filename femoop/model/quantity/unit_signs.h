#pragma once

#include <string>
#include <string_view>

#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/units.h"

namespace femoop {

/// A quantity or unit as print has it, written as files write it: "kN·m" is "kN*m", "cm⁴" is "cm^4", "30°" is "30deg".
/// Both the middle dot (U+00B7) and the dot operator (U+22C5) are products.
std::string with_file_signs(std::string_view printed);

/// A unit or quantity as files write it with the product that print has: "4500 kN·m/rad" of "4500 kN*m/rad".
std::string with_product_dots(std::string_view in_file);

/// `unit_text` as print has it: "kN·m".
std::string printed_unit(Dimension dimension, const Units& units);

} // namespace femoop
