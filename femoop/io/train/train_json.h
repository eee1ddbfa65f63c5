#pragma once

#include <string>
#include <vector>

#include "femoop/io/train/train_results.h"

namespace femoop::influence {

/// Trains, then envelopes, in the units of the model. What is absent is null: the position of a train that is away, the
/// uniform load of one that has none.
std::string trains_json(const Model& model, const std::vector<TrainResults>& results);

} // namespace femoop::influence
