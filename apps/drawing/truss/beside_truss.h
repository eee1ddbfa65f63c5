#pragma once

#include "apps/drawing/sheet/panel_head.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/drawing/truss/truss_picture.h"

#include <optional>

namespace drawing {

/// What stands beside a truss that is worked out: its Cremona diagram, or the joint of the stage.
void draw_beside_truss(const Scene& scene, const TrussPicture& picture, const ui::Box& panel);
PanelHead beside_truss_head(const Scene& scene, const TrussPicture& picture, const ui::Box& panel);

/// The bar that the pointer means there, at most `reach` pixels off.
std::optional<femoop::MemberId> bar_beside_at(const TrussPicture& picture, const ui::Box& panel, const ui::Theme& theme,
                                              ui::Point at, double reach);

} // namespace drawing
