#pragma once

#include <string>

#include "femoop/model/model.h"

namespace femoop {

/// The model without load cases, and without what speaks of them: combinations, moving loads and expected results.
Model without_loads(Model model);

/// A unit force (couple) along a displacement (rotation), at its place: of a node, or along an axis of a member. On a
/// bar its ends share it.
/// \pre the effect is a displacement, with its place  \param id  of the case
LoadCase unit_load_case(const Model& model, const MovingEffect& displacement, std::string id);

} // namespace femoop
