#pragma once

#include <cstddef>

#include "femoop/model/model.h"

namespace femoop {

/// About how much memory the model takes [bytes], its texts as they are usually typed: to bound what a history keeps,
/// not to measure.
std::size_t memory_footprint(const Model& model);

} // namespace femoop
