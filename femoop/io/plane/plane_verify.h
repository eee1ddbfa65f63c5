#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "femoop/io/plane/plane_file.h"
#include "femoop/io/verify.h"
#include "femoop/model/fault/translator.h"
#include "femoop/plane/analysis/natural_modes.h"
#include "femoop/plane/analysis/plane_results.h"

namespace femoop::plane {

bool needs_linear_analysis(const PlaneModel& model);
/// How many natural modes its checks ask for; 0 where none is of them.
std::size_t n_modes_needed(const PlaneModel& model);

/// What the checks of a model are compared with; nothing of what none of them needs.
struct PlaneFindings {
    std::optional<PlaneResults> results{};
    std::optional<NaturalModes> modes{};
};

/// How checks of a drawing are read.
struct DrawnChecks {
    std::function<std::optional<double>(const PlaneExpected& check)> count_or_area; ///< of the drawing
    const std::vector<PlaneExpected>* of_mesh = nullptr; ///< each entry as the mesh has it, of which the results are
};

/// Compares every `expected` entry of the model with its results, in file order, as `femoop::verify` does those of
/// structures of members. Counts and areas of a mesh in the file are skipped by name.
/// \pre `check(model)` finds no error; what was found is of the model itself or of its mesh
std::vector<CheckOutcome> verify(const PlaneModel& model, const PlaneFindings& found,
                                 const std::optional<DrawnChecks>& drawn = {}, const Translator& tr = english);

} // namespace femoop::plane
