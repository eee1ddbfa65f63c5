#pragma once

#include <string_view>

namespace ui {

/// How a camera was held, as the JPEG file that it wrote says it, by the numbers of the standard:
///
///     1  as the pixels are stored                5  mirrored about the diagonal from the top left
///     2  mirrored left to right                  6  to be turned to the right by 90 degrees
///     3  to be turned by 180 degrees             7  mirrored about the other diagonal
///     4  mirrored top to bottom                  8  to be turned to the left by 90 degrees
///
/// 1 where the file says nothing, or nothing that can be understood.
/// Source [CIPA DC-008-2019, Exif 2.32, 4.6.4 A: Orientation]
int exif_orientation(std::string_view jpeg);

} // namespace ui
