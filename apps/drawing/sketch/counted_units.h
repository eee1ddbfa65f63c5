#pragma once

#include <optional>
#include <span>

#include "apps/drawing/draw_options.h"
#include "femoop/model/model.h"

namespace drawing {

/// What a calculation at the foot of a picture counts in, so that it has the numbers of the picture: the units of its
/// lengths and of its forces, from which those of moments follow there.
struct CountedUnits {
    femoop::Units units;
    double length = 1.0, force = 1.0; ///< a number of the model times these is one in the units
};
CountedUnits counted_units(const femoop::Model& model, const DrawOptions& options);
/// For a result that a unit was chosen for, such as moments in kN·cm, those from which this follows, if there are any.
CountedUnits counted_units(const femoop::Model& model, const DrawOptions& options, ui::Measure result);

/// Of the base units from which all follows that was chosen for these measures, those that have most in common with the
/// present ones; nothing where there are none.
std::optional<femoop::Units> base_units_of(std::span<const ui::Measure> measures, const femoop::Units& present,
                                           const DrawOptions& options);

/// The model in them, without what other analyses keep in its file.
femoop::Model counted_in(const CountedUnits& units, femoop::Model model);

} // namespace drawing
