#pragma once

#include "apps/drawing/draw_input.h"
#include "apps/drawing/draw_options.h"
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/influence_picture.h"
#include "apps/drawing/results/thrust_line.h"
#include "apps/drawing/sheet/panel_head.h"
#include "apps/drawing/sketch/scene.h"

#include <string>
#include <vector>

namespace drawing {

/// What stands at the head of the sheet: the title, and in small the case, the units and how determinate the structure
/// is.
struct SheetHead {
    std::string title;
    std::string line;
};
SheetHead sheet_head(const DrawInput& input, const DrawOptions& options);
/// On a sheet of this width [logical pixels], which longer lines are broken for.
double head_height(const SheetHead& head, const ui::Theme& theme, const ui::Fonts& fonts, double width);
void draw_head(ui::Painter& painter, const SheetHead& head, const ui::Theme& theme);

PanelHead diagram_head(const Scene& scene, const std::vector<Diagram>& diagrams);
PanelHead deformed_head(const Scene& scene, double scale);
PanelHead thrust_head(const Scene& scene, const std::optional<LargestEccentricity>& largest);
PanelHead influence_head(const Scene& scene, const InfluencePicture& picture, const InfluenceScale& scale);
/// Of a diagram of forces: its unit and its scale.
PanelHead force_diagram_head(const Scene& scene, const std::string& name, double pixels_per_unit);
PanelHead structure_head(const Scene& scene);

} // namespace drawing
