#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "femoop/io/results/matrix_table.h"
#include "femoop/methods/derivation/derivation.h"
#include "femoop/model/fault/translator.h"

namespace femoop {
class JsonWriter;
}

namespace femoop::derivation {

/// What a step does, in a sentence or two.
std::string sentence(const Step& step, const Model& model, const Translator& tr);

/// What is derived, whose effect bears a name: "M(BC, 50%)", of a difference "ΔM(BC, 50%)".
std::string number_name(const Derivation& derivation, const std::string& effect_name);
/// "M(BC, 50%) = 12.5 kN·m in wind: where it comes from", or "Force method in wind"
std::string derivation_title(const Derivation& derivation, const Model& model, const Translator& tr);
/// In which units its matrices are.
std::string derivation_units(const Model& model, const Translator& tr);

/// How a step's numbers are written on paper.
enum class Notation : std::uint8_t {
    Matrix, ///< in brackets
    List,   ///< named numbers beside one another
    Mixed,  ///< named numbers of several units, such as a length and a stiffness: each has its own digits
    Sum     ///< named numbers below one another, the last row their sum
};
/// \pre the matrix is one of the step's
Notation notation_of(const Step& step, const NamedMatrix& matrix);

RowUnits row_units(Notation notation);

/// Significant digits: the usual ones, and those that products with its numbers lose.
int written_digits(const NamedMatrix& matrix, int usual = 6);

/// K u = f: its matrices stand in one line.
bool is_system(const Step& step);
/// Is this number one that the step is about: of k one that has a place in K, of K and f one of the step's rows?
bool is_lit(const Step& step, const NamedMatrix& matrix, std::size_t row, std::size_t column);

/// What people read of a symbol, or of a name beside a row: the words among them in the language of `tr`, and its
/// decimal mark in places, "M(BC, 2,25)".
std::string symbol_text(const std::string& symbol, const Translator& tr);

/// L³ for L^3, Tᵀ for T^T.
std::string with_raised_powers(std::string text);

/// The steps one below the other: sentence, then numbers with their names.
std::string derivation_text(const Derivation& derivation, const Model& model, const Translator& tr);

/// What is to be said where the sums on paper have fewer digits than the analysis; else nothing.
std::string closing_text(const Derivation& derivation, const Translator& tr);

/// The same as a part of a LaTeX document that uses the package amsmath: a section*, and a paragraph for each step with
/// matrices as bmatrix, what the step is about in bold, and named numbers as tabular.
std::string derivation_latex(const Derivation& derivation, const Model& model, const Translator& tr);

/// The same for a program, with every digit; the sentences are in the language of `tr`.
std::string derivation_json(const Derivation& derivation, const Model& model, const Translator& tr);
void write_why(JsonWriter& json, const Derivation& derivation, const Model& model, const Translator& tr);
void write_steps(JsonWriter& json, const Derivation& derivation, const Model& model, const Translator& tr);

} // namespace femoop::derivation
