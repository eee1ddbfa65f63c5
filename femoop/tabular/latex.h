#pragma once

#include <string>
#include <string_view>

#include "femoop/tabular/table.h"

namespace tabular {

/// A text as LaTeX writes it, in text as in mathematics: the ten characters that mean something to it are escaped,
/// Greek letters take the letters and digits after them as an index, signs and a minus before a number are mathematics.
/// What is left beyond ASCII are the accents of the language.
std::string latex_text(std::string_view text);

/// A formula as LaTeX writes it in mathematics: "−42,7 + 5,06e+01 x²" as "-42{,}7 + 5{,}06\cdot 10^{1} x^2".
std::string latex_formula(std::string_view text);

/// A `tabular`: headings between rules where there are any, rows that are sums below another. Title and notes are left
/// out.
std::string latex(const Table& table);

} // namespace tabular
