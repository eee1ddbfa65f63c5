#pragma once

#include <cstddef>
#include <vector>

#include "femoop/methods/cross/distribution.h"

namespace cross {

/// A number that stands in a column.
struct Cell {
    femoop::cross::RowKind kind = femoop::cross::RowKind::FixedEnd;
    double value = 0.0;
    std::size_t level = 0; ///< the line that it stands on
    std::size_t step = 0;  ///< 1 for the first turn; 0: the fixed-end moment
};

/// What was written at one member end, downwards. The balances of one joint stand on one line, underlined.
struct Column {
    femoop::cross::EndId end;
    std::vector<Cell> cells;
    std::size_t n_levels = 0;
};

/// Of every end, in the order of the ends.
std::vector<Column> columns_of(const femoop::cross::Problem& problem, const femoop::cross::Sheet& sheet);

} // namespace cross
