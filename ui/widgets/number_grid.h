#pragma once

#include <string>
#include <vector>

namespace ui {

using NumberRows = std::vector<std::vector<std::string>>;

/// Numbers in rows and columns, as a matrix is printed: flush right, with lines between the columns.
/// \pre the rows are equally long
void number_grid(const char* id, const NumberRows& rows);

/// The part of the usual type in which every number has room in a column [px] of this width, at most 1.
float type_in_column(const NumberRows& rows, float width);

} // namespace ui
