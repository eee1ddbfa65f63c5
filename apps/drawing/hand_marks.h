#pragma once

#include <cstdint>
#include <string>

#include "ui/canvas/plane_camera.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"

namespace drawing {

/// The sign of what a place was drawn to.
enum class SnapGlyph : std::uint8_t {
    Square,    ///< a node or a point
    Cross,     ///< a crossing
    Triangle,  ///< a middle
    Corner,    ///< a foot at a right angle
    Hourglass, ///< a place on a line
    Plus,      ///< the grid
    Circle,    ///< a round direction
    Dot        ///< nothing
};
void draw_snap(ui::Painter& painter, const ui::Theme& theme, ui::Point at, SnapGlyph glyph);

/// A text beside a place, on a plate: at its right hand, at its left where the sheet ends.
void draw_note(ui::Painter& painter, const ui::Theme& theme, ui::Point beside, const std::string& text);
/// The style of such a text.
ui::TextStyle note_style(const ui::Theme& theme, ui::Anchor anchor);

/// What has been typed of a place, with the mark where it goes on.
std::string typed_so_far(const std::string& typed);
/// The same at the foot of the sheet, where no pointer is over it.
void draw_typed(ui::Painter& painter, const ui::Theme& theme, const std::string& typed);

/// The step of a grid of lines so far apart, or ten times, a hundred times ... as far where they would lie too near.
double wide_enough(double step, double scale);
/// The crossings of a grid's lines, as dots.
void draw_grid(ui::Painter& painter, const ui::Theme& theme, const ui::PlaneCamera& camera, double step);

} // namespace drawing
