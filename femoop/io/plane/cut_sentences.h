#pragma once

#include <string>
#include <vector>

#include "femoop/io/results/result_units.h"
#include "femoop/model/fault/translator.h"
#include "femoop/plane/analysis/plane_results.h"

namespace femoop::plane {

/// What is to be said of cuts whose stresses do not balance what lies beyond them.
std::vector<std::string> cut_sentences(const PlaneResults& results, const PlaneCase& result,
                                       const std::vector<Cut>& cuts, const ResultUnits& units, const Translator& tr);

} // namespace femoop::plane
