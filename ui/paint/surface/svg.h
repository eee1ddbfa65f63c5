#pragma once

#include "ui/paint/picture.h"
#include "ui/paint/text_measure.h"

#include <string>

namespace ui {

/// The picture as an SVG 1.1 document.
///
/// Text stays text, so it can be searched, copied and edited. Each string carries its measured width (`textLength`),
/// so that it takes the same room whatever font the reader has; DejaVu Sans is asked for first.
std::string svg_document(const Picture& picture, const Fonts& fonts, Color background);

} // namespace ui
