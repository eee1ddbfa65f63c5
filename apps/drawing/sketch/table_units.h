#pragma once

#include "femoop/io/results/result_units.h"
#include "ui/text/display_units.h"

namespace drawing {

/// The units of a picture's numbers, for tables beside it.
femoop::ResultUnits table_units(const ui::DisplayUnits& units);

} // namespace drawing
