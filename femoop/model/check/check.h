#pragma once

#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"

namespace femoop {

/// Everything that is wrong with a model, errors and warnings, each naming the guilty parts and a remedy:
/// duplicate ids, references to nothing, values out of range, loads beyond a member's end, combinations that
/// name themselves, coincident nodes, unused parts, members that cross without a node, ...
std::vector<Fault> check(const Model& model);

/// \throws ModelError with every error of the model; warnings are no reason.
void require_sound(const Model& model);

} // namespace femoop
