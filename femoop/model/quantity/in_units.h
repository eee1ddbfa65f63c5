#pragma once

#include "femoop/model/model.h"

namespace femoop {

/// The same structure with its bare numbers counted in other base units. A quantity typed with a unit keeps its text.
///
/// Accuracy  one rounding of the shortest decimal of a number, so 0.0002 m^4 is 2e8 mm^4; values that take no part of a
/// length or a force stay bit for bit \pre `model.extra` is empty: what is in those blocks only their own analyses
/// understand
Model in_units(const Model& model, const Units& units);

} // namespace femoop
