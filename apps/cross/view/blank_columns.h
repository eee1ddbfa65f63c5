#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "apps/cross/view/worksheet.h"

namespace cross {

/// A cell in a column of a pupil's sheet.
struct BlankCell {
    femoop::cross::BlankId blank;
    std::size_t line = 0;
    std::string label; ///< "k", "µ", "M", the number of the turn, "Σ"
};

/// The cells at one member end, downwards: stiffness, factor, fixed-end moment; then line by line the balances of a
/// joint side by side, and what is carried over; the sum.
struct BlankColumn {
    femoop::cross::EndId end;
    std::vector<BlankCell> cells;
    std::size_t n_lines = 0;
};

/// Of every end, in the order of the ends. \param stage  the sheet, or n_sheets() for what follows from all of them
std::vector<BlankColumn> blank_columns(const Worksheet& worksheet, std::size_t stage);

/// Cells that belong to no end: forces of props and how often the sways are added.
std::vector<BlankCell> superposition_cells(const Worksheet& worksheet);

} // namespace cross
