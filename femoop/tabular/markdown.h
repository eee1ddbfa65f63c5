#pragma once

#include <string>
#include <string_view>

#include "femoop/tabular/table.h"

namespace tabular {

/// A text as a cell of a table shows it: what means something to Markdown stands after a backslash.
std::string markdown_text(std::string_view text);

/// The title as a heading, the notes as paragraphs, and a table with pipes as GitHub and Pandoc read it.
std::string markdown(const Table& table);

} // namespace tabular
