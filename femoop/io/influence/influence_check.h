#pragma once

#include <vector>

#include "femoop/io/verify.h"
#include "femoop/model/fault/translator.h"
#include "femoop/model/model.h"

namespace femoop::influence {

/// Compares the lines of a model's `influence` block: every value, the largest and smallest, and all their places, each
/// within 1e-5 of the path's length. A place that the line has and the file does not list fails. Nothing for a model
/// without the block. \throws ModelError, MechanismError
std::vector<CheckOutcome> check_block(const Model& model, const Translator& tr = english);

} // namespace femoop::influence
