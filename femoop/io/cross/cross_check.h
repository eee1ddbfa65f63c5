#pragma once

#include <vector>

#include "femoop/io/cross/cross_block.h"
#include "femoop/io/verify.h"

namespace femoop::cross {

/// Works the sheet of a model's `cross` block in its order and compares: factors, fixed-end moments, each row (the end
/// that is furthest off), `stages` (stage_check.h), and `final` with the stiffness solution. Nothing for a model
/// without the block. \throws ModelError, MechanismError
std::vector<CheckOutcome> check_block(const Model& model, const Translator& tr = english);

} // namespace femoop::cross
