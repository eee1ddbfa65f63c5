#pragma once

#include "apps/cross/view/panels.h"

namespace cross {

/// The calculation as by hand, on the structure's own sketch: at each member end the box of its distribution factor,
/// its fixed-end moment, balances and carry-overs downwards, each balance underlined, and the sum. Where a column is
/// full the oldest numbers leave it. The last turn stands out, and while it is on its way its numbers fly to their
/// places: balances from the joint, carry-overs from the near end.
/// \returns how many member ends have no room for their columns, seen or not
std::size_t draw_sheet(ui::Painter& painter, const Panel& panel, const Scene& scene);

} // namespace cross
