#pragma once

#include "ui/paint/paint_to_file.h"

namespace ui {

/// Runs the drawing and writes it as PNG, `sheet.scale` physical pixels to a logical one.
/// \throws std::invalid_argument as `painted`
/// \throws std::runtime_error, in a sentence, when the file cannot be written, the font is missing (FontError) or
/// there is no off-screen renderer (ContextError)
void paint_to_png(const std::filesystem::path& path, const Sheet& sheet, const Drawing& drawing);

} // namespace ui
