#pragma once

#include "apps/drawing/geometry/diagram_plan.h"
#include "apps/drawing/sheet/panel_head.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/drawing/truss/truss_picture.h"

#include <optional>

namespace drawing {

/// Of the points of its spaces.
DiagramPlan plan_of(const femoop::truss::Reciprocal& diagram, const ui::Box& panel, const ui::Theme& theme);

/// The diagram as far as it has come: each side with the line of its bar, the points with the small letters of their
/// spaces. What the stage adds is lit, and arrow heads go around the polygon of its joint. \pre the picture has a diagram
void draw_reciprocal(const Scene& scene, const TrussPicture& picture, const ui::Box& panel);
PanelHead reciprocal_head(const Scene& scene, const TrussPicture& picture, const ui::Box& panel);

/// The bar whose side lies at this place of the sheet, at most `reach` pixels off, among those that are drawn.
std::optional<femoop::MemberId> side_at(const TrussPicture& picture, const DiagramPlan& plan, ui::Point at,
                                        double reach);

} // namespace drawing
