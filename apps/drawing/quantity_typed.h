#pragma once

#include <string_view>
#include <variant>

#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/quantity.h"
#include "femoop/model/quantity/units.h"
#include "ui/text/display_units.h"

namespace drawing {

/// Reads what a person typed for a number: with a unit (`25 kN/m`), or without, then in the unit that the field shows.
/// A decimal comma is understood, and so are calculations and sums of terms with units (`1.3 m + 10 cm`). The quantity
/// keeps the unit if it is not the file's own, so nothing converted is saved; a sum is in the file's.
std::variant<femoop::Quantity, femoop::Fault> quantity_typed(std::string_view text, ui::Measure measure,
                                                             const femoop::Units& file, const ui::DisplayUnits& shown);

/// The same of what has no measure of its own, such as E I.
std::variant<femoop::Quantity, femoop::Fault> quantity_typed(std::string_view text, femoop::Dimension dimension,
                                                             const femoop::Units& file, const ui::DisplayUnit& shown);

/// That of what is measured; none of a plain number.
femoop::Dimension dimension_measured(ui::Measure measure);

/// The names and sizes of the file's base units, for ui::DisplayUnits.
ui::BaseUnits base_units(const femoop::Units& units);

} // namespace drawing
