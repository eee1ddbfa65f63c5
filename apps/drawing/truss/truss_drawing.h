#pragma once

#include "apps/drawing/sheet/panel_head.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/drawing/truss/truss_picture.h"

namespace drawing {

inline constexpr ui::Role letter_role = ui::Role::LocalAxes; // of spaces and of their points
inline constexpr ui::Role lit_role = ui::Role::Selection;    // of what a stage is about

/// The truss: bars by their sense, in tension a full line, in compression dashes, dots where they carry nothing; the
/// forces from outside, whole, and by Bow's notation the name of each space. Bars that are not found yet are thin.
void draw_truss(const Scene& scene, const TrussPicture& picture);
PanelHead truss_head(const Scene& scene, const TrussPicture& picture);

/// Hue and dashes both tell the sense of a bar.
ui::Stroke stroke_of(const Scene& scene, double force);
ui::Role role_of(double force);

double distance_to_segment(ui::Point at, ui::Point a, ui::Point b);

} // namespace drawing
