#pragma once

#include "apps/cross/view/block_layout.h"
#include "apps/cross/view/sheet_bays.h"

namespace cross {

/// What a sheet shows of its columns.
struct DrawnSheet {
    std::size_t n_left_out = 0; ///< member ends without room for their columns, seen or not
    double type = 0.0;          ///< size of the numbers
    /// How far an enlarged sheet is to be moved along so that the columns of the last turn, or of the next where there
    /// was none, are seen whole; nothing where they are.
    std::optional<ui::Point> way_to_turn;
};

/// The calculation as by hand, on the structure's own sketch: at each member end the box of its distribution factor,
/// its fixed-end moment, balances and carry-overs downwards, each balance underlined, and the sum. Where a column is
/// full the oldest numbers leave it. The last turn stands out, and while it is on its way its numbers fly to their
/// places: balances from the joint, carry-overs from the near end. On the projector no number is smaller than the
/// panels' text.
DrawnSheet draw_sheet(ui::Painter& painter, const Panel& panel, const Scene& scene);

/// What of the room a frame leaves to its columns, and how they stand there.
struct FittedSheet {
    SheetRoom room{};
    BayScale storeys{}; ///< heights, as the columns need them
    BlockLayout layout{};
};
FittedSheet fitted_sheet(ui::Painter& painter, const Panel& whole, const Scene& scene);
/// Every member end that is there has room for a short column, in type that the last row reads.
bool is_legible(ui::Painter& painter, const Panel& panel, const Scene& scene);
/// What the columns of a sheet need. \param whole  the sheet as it is without a zoom
ColumnNeeds column_needs(ui::Painter& painter, const Panel& whole, const Scene& scene);
/// Its spans, with a column for every member end.
std::vector<Bay> bays_of_sheet(const Scene& scene);
/// How the spans of a beam's sheet are drawn so that its columns find room; a frame's to scale.
BayScale sheet_bays(ui::Painter& painter, const Panel& whole, const Scene& scene);

} // namespace cross
