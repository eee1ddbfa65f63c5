#pragma once

#include <string>
#include <vector>

#include "femoop/io/results/result_units.h"
#include "femoop/io/train/train_results.h"
#include "femoop/model/fault/translator.h"

namespace femoop::influence {

/// What trains do, as tables a person can read: a component a table, then the extremes of each member. A single effect
/// is told axle by axle.
std::string trains_text(const Model& model, const std::vector<TrainResults>& results, const ResultUnits& units,
                        const Translator& tr);

const PrintedUnit& unit_of(const ResultUnits& units, const MovingEffect& effect); ///< of its value

} // namespace femoop::influence
