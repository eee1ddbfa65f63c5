#pragma once

#include "apps/cross/view/block_layout.h"
#include "apps/cross/view/sheet_bays.h"

namespace cross {

/// The calculation as by hand, on the structure's own sketch: at each member end the box of its distribution factor,
/// its fixed-end moment, balances and carry-overs downwards, each balance underlined, and the sum. Where a column is
/// full the oldest numbers leave it. The last turn stands out, and while it is on its way its numbers fly to their
/// places: balances from the joint, carry-overs from the near end.
/// \returns how many member ends have no room for their columns, seen or not
std::size_t draw_sheet(ui::Painter& painter, const Panel& panel, const Scene& scene);

/// What of the room a frame leaves to its columns, and how they stand there.
struct FittedSheet {
    SheetRoom room{};
    BlockLayout layout{};
};
FittedSheet fitted_sheet(ui::Painter& painter, const Panel& whole, const Scene& scene);
/// What the columns of a sheet need. \param whole  the sheet as it is without a zoom
ColumnNeeds column_needs(ui::Painter& painter, const Panel& whole, const Scene& scene);
/// Its spans, with a column for every member end.
std::vector<Bay> bays_of_sheet(const Scene& scene);
/// How the spans of a beam's sheet are drawn so that its columns find room; a frame's to scale.
BayScale sheet_bays(ui::Painter& painter, const Panel& whole, const Scene& scene);

} // namespace cross
