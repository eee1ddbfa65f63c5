#pragma once

#include "apps/drawing/sheet/panel_head.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/drawing/truss/truss_picture.h"

#include <optional>

namespace drawing {

/// The joint of the stage, lifted out of the truss: the stubs of its bars with their forces as they act on it, those that
/// are unknown with their symbols, the loads and reactions; and its force polygon to scale. While bars are unknown their
/// lines have no end there. Of bars that carry nothing the joint stands alone, and at last the rule of each.
void draw_joint(const Scene& scene, const TrussPicture& picture, const ui::Box& panel);
PanelHead joint_head(const Scene& scene, const TrussPicture& picture, const ui::Box& panel);

/// The bar that the pointer means there, by its stub or by its side of the polygon, at most `reach` pixels off.
std::optional<femoop::MemberId> bar_of_joint_at(const TrussPicture& picture, const ui::Box& panel,
                                                const ui::Theme& theme, ui::Point at, double reach);

} // namespace drawing
