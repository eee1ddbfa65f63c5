#pragma once

#include <vector>

#include "femoop/io/verify.h"
#include "femoop/model/fault/translator.h"
#include "femoop/model/model.h"

namespace femoop::influence {

/// Runs the train of a model's block over its path and compares what comes of it with the block's answers: a value
/// each, and the sections of an extreme, all that there are, each within 1e-5 of the path's length.
/// None without such a block. \throws ModelError, MechanismError
std::vector<CheckOutcome> check_train_block(const Model& model, const Translator& tr);

} // namespace femoop::influence
