#include "apps/drawing/sketch/counted_units.h"

#include <utility>

#include "apps/drawing/sketch/scene.h"
#include "femoop/model/quantity/in_units.h"

namespace drawing {

CountedUnits counted_units(const femoop::Model& model, const DrawOptions& options)
{
    const ui::DisplayUnits shown = display_units(model, options);
    const ui::DisplayUnit length = shown.unit(ui::Measure::Length), force = shown.unit(ui::Measure::Force);
    const auto length_unit = femoop::find_length_unit(length.name);
    const auto force_unit = femoop::find_force_unit(force.name);
    if (!length_unit || !force_unit) return {model.units};
    return {{*length_unit, *force_unit}, length.factor, force.factor};
}

femoop::Model counted_in(const CountedUnits& units, femoop::Model model)
{
    if (units.units == model.units) return model;
    model.extra.clear();
    return femoop::in_units(model, units.units);
}

} // namespace drawing
