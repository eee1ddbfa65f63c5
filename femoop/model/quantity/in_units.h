#pragma once

#include "femoop/model/model.h"
#include "femoop/model/quantity/dimension.h"

namespace femoop {

/// The same structure with its bare numbers counted in other base units. A quantity typed with a unit keeps its text.
///
/// Accuracy  one rounding of the shortest decimal of a number, so 0.0002 m^4 is 2e8 mm^4; values that take no part of a
/// length or a force stay bit for bit \pre `model.extra` is empty: what is in those blocks only their own analyses
/// understand
Model in_units(const Model& model, const Units& units);

/// The same of one number of a file.
Quantity in_units(const Quantity& quantity, Dimension dimension, const Units& from, const Units& to);

/// The same of a material, which structures of members and plane models have alike.
Material in_units(const Material& material, const Units& from, const Units& to);

} // namespace femoop
