#pragma once

#include <string>
#include <vector>

#include "femoop/methods/cross/problem.h"
#include "femoop/model/fault/translator.h"

namespace femoop::cross {

/// Why half of a structure is enough, in sentences: about which axis and which joints are balanced; what stiffness
/// members that cross it take; what stands still on it. \pre half.mirror
std::vector<std::string> half_text(const Model& model, const Problem& half, const Translator& tr = english);

} // namespace femoop::cross
