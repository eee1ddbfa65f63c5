#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "apps/cross/view/panels.h"

namespace cross {

/// Where the columns of a frame's uppermost beam stand.
enum class TopColumns : std::uint8_t { Above, Below };

/// What the columns of a frame's sheet need.
struct StoreyNeeds {
    double type = 13.0;  ///< of the numbers
    double width = 65.0; ///< of a column [px]
    std::size_t n_lines = 4;
    TopColumns top = TopColumns::Above;
};

/// Each as high as it is, in a panel that gives a frame's columns all the room that they ask for.
BayScale storeys_to_scale(const drawing::StructureShape& shape);
/// Room around a frame for the columns outside it alone.
SheetRoom tight_room(const StoreyNeeds& needs, const ui::Theme& theme);
/// Storeys as high as their columns need, one over another at both ends of each member; to scale where the panel is too
/// low for that.
/// \param sheet  with the room around the frame
BayScale storey_scale_for(const drawing::StructureShape& shape, const Panel& sheet, const StoreyNeeds& needs);

} // namespace cross
