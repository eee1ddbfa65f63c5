#pragma once

#include "apps/frame/view/results/diagram.h"
#include "apps/frame/view/sketch/scene.h"
#include "femoop/result/results.h"

#include <string>
#include <vector>

namespace frame {

/// What stands at the head of the sheet: the title, and in small the case, the units and how determinate the structure
/// is.
struct SheetHead {
    std::string title;
    std::string line;
};
SheetHead sheet_head(const femoop::Model& model, const femoop::Results* results, const ViewOptions& options);
/// On a sheet of this width [logical pixels], which longer lines are broken for.
double head_height(const SheetHead& head, const ui::Theme& theme, const ui::Fonts& fonts, double width);
void draw_head(ui::Painter& painter, const SheetHead& head, const ui::Theme& theme);

/// What stands over one panel: its name, and a line about signs or scales.
struct PanelHead {
    std::string name;
    std::string note;
    ui::Role role = ui::Role::Label;
    double bar = 0.0;       ///< length of the scale bar in logical pixels; 0: none
    std::string bar_text{}; ///< what it stands for
};
PanelHead diagram_head(const Scene& scene, const std::vector<Diagram>& diagrams);
PanelHead deformed_head(const Scene& scene, double scale);
PanelHead structure_head(const Scene& scene);
/// In a narrow panel a head takes two lines.
double head_height(const ui::Theme& theme, double panel_width);
/// \param row  the strip at the top of the panel that the head may use
void draw_panel_head(ui::Painter& painter, const PanelHead& head, const ui::Theme& theme, const ui::Box& row);

/// Sentences broken into lines of at most `width` logical pixels, at the foot of the sheet.
std::vector<std::string> wrapped(const ui::Fonts& fonts, std::string_view text, const ui::TextStyle& style,
                                 double width);

} // namespace frame
