#pragma once

#include <string>

#include "femoop/io/truss/truss_sheet.h"

namespace femoop::truss {

std::string plain_text(const Sheet& sheet, const Translator& tr);

/// The body of a LaTeX document: sections, paragraphs, equations and tabulars.
std::string latex(const Sheet& sheet);

} // namespace femoop::truss
