#pragma once

#include <string>
#include <vector>

#include "femoop/analysis/trace.h"
#include "femoop/io/results/result_units.h"
#include "femoop/model/fault/translator.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop {

/// What the model is: title, kind of analysis, units, how many parts, degree of static indeterminacy, warnings.
std::string heading_text(const Model& model, const Results& results, const Translator& tr);

/// Displacements, reactions, forces at member ends, extremes with their places, sums and residual of one case.
/// Columns carry units; round-off beside large numbers reads 0 (femoop/io/results/text_table.h).
std::string case_text(const Model& model, const Results& results, CaseId id, const Translator& tr);
/// The same in chosen units.
std::string case_text(const Model& model, const Results& results, CaseId id, const ResultUnits& units,
                      const Translator& tr);

/// Largest and smallest of everything over these cases, with the case that governs.
std::string envelope_text(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                          const Translator& tr);
/// The same in chosen units.
std::string envelope_text(const Model& model, const Results& results, const std::vector<CaseId>& cases,
                          const ResultUnits& units, const Translator& tr);

/// A member's matrices and fixed-end forces with rows and columns named, as a student writes them.
std::string trace_text(const MemberTrace& trace, const Units& units, const Translator& tr);

} // namespace femoop
