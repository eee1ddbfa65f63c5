#pragma once

#include "ui/paint/painter.h"

#include <filesystem>
#include <functional>
#include <string>

namespace ui {

/// The paper that a drawing is put on.
struct Sheet {
    Size size{1280.0, 800.0}; ///< logical pixels
    double scale = 1.0;       ///< physical pixels of a logical one, in PNG alone
    Color background = rgb(0xFFFFFF);
    std::string title{}; ///< of the PDF document
};

/// What draws: called once with an empty painter of the sheet's size.
using Drawing = std::function<void(Painter&)>;

/// Runs the drawing. \throws std::invalid_argument for a sheet without area or larger than 16384 pixels a side.
Picture painted(const Sheet& sheet, const Fonts& fonts, const Drawing& drawing);

/// Runs the drawing and writes it. All give the same picture; `paint_to_png` stands in ui/context/paint_to_png.h,
/// since it needs the off-screen renderer.
/// \throws std::invalid_argument as `painted`
/// \throws std::runtime_error, in a sentence, when the file cannot be written or the font is missing (FontError)
void paint_to_svg(const std::filesystem::path& path, const Sheet& sheet, const Drawing& drawing);
void paint_to_pdf(const std::filesystem::path& path, const Sheet& sheet, const Drawing& drawing);
/// The golden text (ui/paint/surface/golden_text.h).
std::string paint_to_text(const Sheet& sheet, const Drawing& drawing);

} // namespace ui
