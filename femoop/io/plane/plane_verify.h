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

/// How checks of a drawing are read.
struct DrawnChecks {
    std::function<std::optional<double>(const PlaneExpected& check)> count_or_area; ///< of the drawing
    const std::vector<PlaneExpected>* of_mesh = nullptr; ///< each entry as the mesh has it, of which the results are
};

/// Compares every `expected` entry of the model with its results, in file order, as `femoop::verify` does those of
/// structures of members. Modes are skipped by name, and counts and areas of a mesh in the file.
/// \pre `check(model)` finds no error; `results` are the model's own or its mesh's, or nothing if no check needs them
std::vector<CheckOutcome> verify(const PlaneModel& model, const std::optional<PlaneResults>& results,
                                 const std::optional<DrawnChecks>& drawn = {}, const Translator& tr = english);

} // namespace femoop::plane
