#pragma once

#include <string>

#include "femoop/io/json/json_writer.h"
#include "femoop/io/results/result_units.h"
#include "femoop/model/fault/translator.h"
#include "femoop/result/difference.h"

namespace femoop {

/// The same structure with its bare numbers in other base units, to be compared with one that counts in them. What only
/// other analyses understand is left out.
Model comparable(Model model, const Units& units);

/// Section forces, reactions and displacements of a case beside those of another, each with the change, as tables; below
/// them what only one of the structures has.
///
/// Signs  change = now - before
/// \pre   both models are of one kind and count in the same units
std::string differences_text(const ComparedCase& now, const ComparedCase& before, const ResultUnits& units,
                             const Translator& tr);

/// The greatest change of each component, one sentence a line.
std::string differences_sentences(const ComparedCase& now, const ComparedCase& before, const ResultUnits& units,
                                  const Translator& tr);

/// {"section_forces": [..], "reactions": [..], "displacements": [..], "only_now": {..}, "only_before": {..}}
void write_differences(JsonWriter& json, const ComparedCase& now, const ComparedCase& before);

} // namespace femoop
