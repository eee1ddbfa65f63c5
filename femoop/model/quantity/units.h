#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "femoop/model/quantity/dimension.h"

namespace femoop {

enum class LengthUnit : std::uint8_t { m, mm, cm, km, in, ft };
enum class ForceUnit : std::uint8_t { N, kN, MN, lbf, kip, tf, kgf };

/// The base units of a model's bare numbers. Everything else is consistent in them: moments force x length,
/// stresses force / length^2, masses force x s^2 / length. Rotations are radians, temperatures degC.
struct Units {
    LengthUnit length = LengthUnit::m;
    ForceUnit force = ForceUnit::kN;

    friend bool operator==(const Units&, const Units&) = default;
};

double metres(LengthUnit unit); ///< one unit in m
double newtons(ForceUnit unit); ///< one unit in N

std::string_view name(LengthUnit unit); ///< "m" ... "ft"
std::string_view name(ForceUnit unit);  ///< "N" ... "kgf"
std::optional<LengthUnit> find_length_unit(std::string_view name);
std::optional<ForceUnit> find_force_unit(std::string_view name);

/// What a bare number of this dimension is counted in: "kN/m", "kN*m", "1/K"; "" for a plain number.
std::string unit_text(Dimension dimension, const Units& units);

} // namespace femoop
