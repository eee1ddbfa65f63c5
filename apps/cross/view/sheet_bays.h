#pragma once

#include <vector>

#include "apps/cross/view/panels.h"
#include "femoop/methods/cross/problem.h"

namespace cross {

/// What the columns of a beam's sheet need beside each other.
struct ColumnNeeds {
    double ems = 5.0;           ///< breadth of a column, of its size of type
    double largest_type = 13.0; ///< of the numbers
    double least_type = 9.0;
    double support = 12.0;  ///< half a support's breadth, which columns keep off [px]
    std::size_t n_rows = 1; ///< 2: below the beam and above it
};

/// One span of a beam's sheet.
struct Bay {
    double start = 0.0, end = 0.0; ///< places along the beam
    std::size_t n_columns = 0;
    bool is_overhang = false; ///< with a support at one end alone
};

/// Spans from node to node, with the columns that these ends have there.
std::vector<Bay> bays_of(const drawing::StructureShape& shape, const femoop::cross::Problem& problem,
                         const std::vector<femoop::cross::EndId>& ends);
/// What a span, or all of them, need for their columns at a size of type [px].
double breadth_needed(const Bay& bay, const ColumnNeeds& needs, double type);
double breadth_needed(const std::vector<Bay>& bays, const ColumnNeeds& needs, double type);
/// The spans of a beam's sheet so broad that every column stands beside its member end, in the largest size of type for
/// which there is room; to scale where that does. Where not even the least type has room they share it by what they
/// need, so that a zoom gives it to all of them.
BayScale bay_scale_for(const std::vector<Bay>& bays, const Panel& sheet, const ColumnNeeds& needs);

/// A stretch of a beam's sheet for one page [px].
struct Stretch {
    double left = 0.0, right = 0.0;
};
/// A sheet that is too broad for a page, cut in the middles of spans so that every joint is whole on one of them.
/// \param whole  the sheet at its full breadth
std::vector<Stretch> cut_into_pages(const Panel& whole, const std::vector<Bay>& bays, double page);

} // namespace cross
