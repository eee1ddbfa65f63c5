#pragma once

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

/// The model in them, without what other analyses keep in its file.
femoop::Model counted_in(const CountedUnits& units, femoop::Model model);

} // namespace drawing
