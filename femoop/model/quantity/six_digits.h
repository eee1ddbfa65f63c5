#pragma once

#include <string>

#include "femoop/model/fault/translator.h"

namespace femoop {

/// A number in a sentence or a table of few numbers: six significant digits, in the reader's language.
std::string six_digits(double value, const Translator& tr);

} // namespace femoop
