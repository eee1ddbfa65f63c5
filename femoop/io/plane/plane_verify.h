#pragma once

#include <optional>
#include <string>
#include <vector>

#include "femoop/io/plane/plane_file.h"
#include "femoop/io/verify.h"
#include "femoop/model/fault/translator.h"
#include "femoop/plane/analysis/plane_results.h"

namespace femoop::plane {

bool needs_linear_analysis(const PlaneModel& model);

/// Compares every `expected` entry of the model with its results, in file order, as `femoop::verify` does those of
/// structures of members. Modes, and counts and areas of a drawing, are skipped by name.
/// \pre `check(model)` finds no error; `results` are the model's own, or nothing if no check needs them
std::vector<CheckOutcome> verify(const PlaneModel& model, const std::optional<PlaneResults>& results,
                                 const Translator& tr = english);

/// The checks of a drawing to be meshed: all skipped.
std::vector<CheckOutcome> skipped_checks(const PlaneReading& drawing);

} // namespace femoop::plane
