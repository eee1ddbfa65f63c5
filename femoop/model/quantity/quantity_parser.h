#pragma once

#include <cstdint>
#include <string_view>
#include <variant>

#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/units.h"

namespace femoop {

enum class AngleUnit : std::uint8_t { Radians, Degrees };

/// Reads a number with a unit, "-25 kN/m", as a value in the base units, or says what is wrong with it.
///
///   quantity = number [unit]        number as in JSON, also ".5" and "+5"
///   unit     = factor { ("*" | "/") factor }
///   factor   = name [ "^" integer ] | "1"
///   name     = m mm cm km in ft | N kN MN lbf kip tf kgf | Pa kPa MPa GPa psi ksi | kg g t lb | s ms Hz
///              | deg rad | K degC degF (differences)
///
/// Also as print has it: "kN·m", "cm⁴", "°C" (femoop/model/quantity/unit_signs.h).
/// A number without a unit is accepted for a dimensionless quantity only. The angle in a rotational stiffness may be
/// left out (kN*m for kN*m/rad). The first argument of the fault is the place: empty here, the caller knows it.
///
/// Accuracy  one rounding: the conversion runs in double-double arithmetic on exact factors
///           (1 in = 0.0254 m, 1 lbf = 4.4482216152605 N, 1 kgf = 9.80665 N, 1 lb = 0.45359237 kg)
std::variant<double, Fault> parse_quantity(std::string_view text, Dimension wanted, const Units& units,
                                           AngleUnit angle = AngleUnit::Radians);

/// A bare number of this dimension taken from one set of base units to another, with one rounding; it may overflow to
/// infinity.
double converted(double value, Dimension dimension, const Units& from, const Units& to);

} // namespace femoop
