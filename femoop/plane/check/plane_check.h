#pragma once

#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// Parts of a model that its file's reader has already complained about. `check` says of such a part what is wrong with
/// the rest of it, not what it lacks.
struct Unreadable {
    bool header = false;        ///< the kind of analysis or the units: nothing can be checked
    bool is_incomplete = false; ///< something is missing, so that what remains may look unused
    std::vector<bool> materials, points, curves, regions, elements;
    std::vector<std::vector<bool>> point_loads, curve_loads, region_loads, settlements; ///< per load case
    std::vector<bool> combinations, expected;
    std::vector<bool> load_cases; ///< their ids alone
};

/// Everything wrong with a plane model, errors and warnings.
std::vector<Fault> check(const PlaneModel& model, const Unreadable& unreadable = {});

/// \throws ModelError with every error of the model; warnings are no reason.
void require_sound(const PlaneModel& model);

} // namespace femoop::plane
