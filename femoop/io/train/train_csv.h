#pragma once

#include <span>
#include <string>

#include "femoop/methods/influence/train/train_analysis.h"

namespace femoop::influence {

/// Effects of trains as comma-separated values, one a line: part (node or member), id, x, component, unit; then of the
/// largest and of the least value the number, the place s of the leading axle (none where the axles are away), whether
/// it runs backwards (yes), and the train.
std::string trains_csv(const Model& model, std::span<const TrainEffect> effects);

} // namespace femoop::influence
