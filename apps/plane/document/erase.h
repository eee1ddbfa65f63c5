#pragma once

#include <span>
#include <vector>

#include "apps/plane/document/document.h"
#include "apps/plane/document/part.h"

namespace plane {

/// Which entries of a model go, by their places in its lists; a list that is shorter than the model's takes nothing of
/// the rest.
struct Erased {
    std::vector<bool> points{}, curves{}, regions{}, materials{};
    std::vector<bool> cases{}; ///< load cases first, then combinations
};

/// Takes entries away, with what refers to them: loads, checks, settlements. \pre no curve that stays is drawn by a
/// point that goes, and no region that stays is made of a material that goes
void erase_entries(PlaneModel& model, const Erased& erased);

/// Takes points, curves and faces away. A polyline or a spline of enough places goes on without an erased point, an arc
/// without a point at its centre; other curves go with their points. Points that only erased curves had go with them.
void erase_parts(Document& document, std::span<const Part> parts);

} // namespace plane
