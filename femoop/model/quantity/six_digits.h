#pragma once

#include <span>
#include <string>

#include "femoop/model/fault/translator.h"

namespace femoop {

/// A number in a sentence or a table of few numbers: six significant digits, in the reader's language.
std::string six_digits(double value, const Translator& tr);

/// "(4, 2.5)", or "(4; 2,5)" where the comma is the decimal mark.
std::string place_text(std::span<const double> coordinates, const Translator& tr);

} // namespace femoop
