#pragma once

#include <cstdint>

#include "apps/cross/view/panels.h"
#include "apps/cross/view/worksheet.h"

namespace cross {

/// For the columns of a frame: as much as other sheets have, or more left and right of a smaller frame.
enum class Room : std::uint8_t { Usual, Beside };

/// The sheet gets the room of the pictures that are not shown; the moments come next to the structure once it is right.
Panels exercise_panels(const drawing::StructureShape& shape, ui::Size size, const ui::Theme& theme,
                       const Worksheet& worksheet, Room room);

} // namespace cross
