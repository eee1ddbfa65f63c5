#pragma once

#include <string>

#include "femoop/methods/cross/kani.h"
#include "femoop/methods/cross/slope_deflection.h"
#include "femoop/model/fault/translator.h"

namespace femoop::cross {

/// Kani's method for people: rotation factors, the contributions cycle by cycle, the moments at the end.
std::string kani_text(const Model& model, const Problem& problem, const Kani& kani, const Translator& tr = english);
/// `rotation_factors`, `fixed_end_moments`, `cycles` (`rotation` and with sways `sway` contributions), `total`.
std::string kani_json(const Model& model, const Problem& problem, const Kani& kani);

/// The slope-deflection equations for people: matrix, right-hand side and unknowns in the base units, the moments.
std::string equations_text(const Model& model, const Problem& problem, const SlopeDeflection& equations,
                           const Translator& tr = english);
/// `unknowns` (names), `matrix` (rows), `right_hand_side`, `solution`, `total`.
std::string equations_json(const Model& model, const Problem& problem, const SlopeDeflection& equations);

} // namespace femoop::cross
