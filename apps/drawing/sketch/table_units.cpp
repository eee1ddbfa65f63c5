#include "apps/drawing/sketch/table_units.h"

namespace drawing {

femoop::ResultUnits table_units(const ui::DisplayUnits& units)
{
    const auto unit = [&](ui::Measure measure) {
        const ui::DisplayUnit found = units.unit(measure);
        return femoop::PrintedUnit{found.name, found.factor};
    };
    return {.length = unit(ui::Measure::Length),
            .displacement = unit(ui::Measure::Displacement),
            .rotation = unit(ui::Measure::Rotation),
            .force = unit(ui::Measure::Force),
            .moment = unit(ui::Measure::Moment),
            .stress = unit(ui::Measure::Stress)};
}

} // namespace drawing
