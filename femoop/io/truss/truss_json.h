#pragma once

#include <string>
#include <vector>

#include "femoop/io/json/json_writer.h"
#include "femoop/methods/truss/reciprocal.h"
#include "femoop/model/fault/translator.h"

namespace femoop::truss {

/// What the sheets (truss_sheet.h) say, for a program, with every digit; sentences are in the language of `tr`.
std::string joint_json(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr);
std::string zero_force_json(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr);
std::string cut_json(const Model& model, const Truss& truss, CaseId load_case, const std::vector<MemberId>& bars,
                     const Translator& tr);
std::string diagram_json(const Model& model, const Truss& truss, CaseId load_case, const Translator& tr);

/// Of "zero_force_bars" the value: bars in the order in which they are found, each with its rule.
void write_zero_force_bars(JsonWriter& json, const Truss& truss, const Model& model, const Translator& tr);

} // namespace femoop::truss
