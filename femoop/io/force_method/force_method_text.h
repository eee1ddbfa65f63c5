#pragma once

#include <string>

#include "femoop/methods/force_method/force_method.h"
#include "femoop/model/fault/translator.h"

namespace femoop::force_method {

/// The steps with their numbers (femoop/methods/force_method/force_steps.h), then the work that each delta is the sum of,
/// as integrals with their formulas. \param model  that was solved
std::string force_method_text(const ForceMethod& method, const Model& model, const Translator& tr);

/// The same for a program, with every digit; the sentences of the steps are in the language of `tr`.
std::string force_method_json(const ForceMethod& method, const Model& model, const Translator& tr);

} // namespace femoop::force_method
