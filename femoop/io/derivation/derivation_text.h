#pragma once

#include <string>

#include "femoop/methods/derivation/derivation.h"
#include "femoop/model/fault/translator.h"

namespace femoop {
class JsonWriter;
}

namespace femoop::derivation {

/// What a step does, in a sentence or two.
std::string sentence(const Step& step, const Model& model, const Translator& tr);

/// "M(BC, 50%) = 12.5 kN·m in wind: where it comes from", or "Force method in wind"
std::string derivation_title(const Derivation& derivation, const Model& model, const Translator& tr);
/// In which units its matrices are.
std::string derivation_units(const Model& model, const Translator& tr);

/// The steps one below the other: sentence, then numbers with their names.
std::string derivation_text(const Derivation& derivation, const Model& model, const Translator& tr);

/// The same as a part of a LaTeX document: a section*, and a paragraph with tables for each step.
std::string derivation_latex(const Derivation& derivation, const Model& model, const Translator& tr);

/// The same for a program, with every digit; the sentences are in the language of `tr`.
std::string derivation_json(const Derivation& derivation, const Model& model, const Translator& tr);
void write_steps(JsonWriter& json, const Derivation& derivation, const Model& model, const Translator& tr);

} // namespace femoop::derivation
