#pragma once

#include <string>
#include <vector>

#include "ui/paint/painter.h"

namespace mohr {

/// A sentence in as many lines as a width asks for; a word wider than that has its own.
std::vector<std::string> lines_of(const ui::Painter& painter, const std::string& words, const ui::TextStyle& style,
                                  double width);

/// Writes a sentence along the foot of a box, on its right, in a room of at least so many lines. \returns what is left
/// of the box above it
ui::Box write_at_foot(ui::Painter& painter, const ui::Box& box, const std::string& words, ui::TextStyle style,
                      std::size_t least_lines);

} // namespace mohr
