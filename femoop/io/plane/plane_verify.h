#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "femoop/io/plane/plane_file.h"
#include "femoop/io/verify.h"
#include "femoop/model/fault/translator.h"
#include "femoop/plane/analysis/plane_results.h"

namespace femoop::plane {

bool needs_linear_analysis(const PlaneModel& model);

/// What a check of a count or of an area finds in the model's drawing; nothing where there is none.
using DrawingReader = std::function<std::optional<double>(const PlaneExpected& check)>;

/// Compares every `expected` entry of the model with its results, in file order, as `femoop::verify` does those of
/// structures of members. Modes, and results of a drawing that is not meshed, are skipped by name.
/// \pre `check(model)` finds no error; `results` are the model's own, or nothing if no check needs them
std::vector<CheckOutcome> verify(const PlaneModel& model, const std::optional<PlaneResults>& results,
                                 const DrawingReader& drawing, const Translator& tr = english);

} // namespace femoop::plane
