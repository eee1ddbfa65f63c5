#pragma once

#include "ui/paint/picture.h"

#include <string>

namespace ui {

/// Every string of a picture with its place, one a line in the order of drawing, after a line that counts the shapes:
///
///     sheet 640 x 400, 12 lines, 3 areas, 2 strings, 0 refused
///     (120.0, 46.5) center 13 bold rotated 90 "12.5 kN"
///
/// Strings out of sight are listed too. The numbers stand with one decimal, so a golden text changes when a string
/// moves by a tenth of a pixel.
std::string golden_text(const Picture& picture);

} // namespace ui
