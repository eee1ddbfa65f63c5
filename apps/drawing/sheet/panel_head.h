#pragma once

#include "ui/paint/painter.h"
#include "ui/paint/theme.h"

#include <string>

namespace drawing {

/// What stands over one panel: its name, a scale bar, and a note about signs or scales.
struct PanelHead {
    std::string name;
    std::string note;
    ui::Role role = ui::Role::Label;
    double bar = 0.0;       ///< length of the scale bar in logical pixels; 0: none
    std::string bar_text{}; ///< what it stands for
};

/// Of as many lines as the head needs in a panel of this width, four at most.
double head_height(const PanelHead& head, const ui::Theme& theme, const ui::Fonts& fonts, double panel_width);

/// Writes name, bar and note beside one another, and below where the line is full, on a ground of their own. What finds
/// no room even there is left out whole: half a number misleads. \param row  the strip at the top of the panel that the
/// head may use
void draw_panel_head(ui::Painter& painter, const PanelHead& head, const ui::Theme& theme, const ui::Box& row);

} // namespace drawing
