#include "femoop/io/results/result_units.h"

#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/unit_signs.h"

namespace femoop {

ResultUnits result_units(const Units& units)
{
    const PrintedUnit length{printed_unit(dimension::length, units)};
    return {.length = length,
            .displacement = length,
            .rotation = {"rad"},
            .force = {printed_unit(dimension::force, units)},
            .moment = {printed_unit(dimension::moment, units)},
            .stress = {printed_unit(dimension::stress, units)}};
}

} // namespace femoop
