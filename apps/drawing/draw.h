#pragma once

#include "apps/drawing/draw_input.h"
#include "apps/drawing/draw_options.h"
#include "apps/drawing/draw_state.h"
#include "femoop/model/dof.h"
#include "ui/paint/painter.h"

namespace drawing {

/// Draws a structure with its loads and, where there are results, what they show, on the painter's whole sheet. Of one
/// that cannot be solved it draws how it moves, and says it in its sentence.
///
/// The drawing is a pure function of its arguments. Each result gets a panel of its own beside the loads and reactions
/// (DrawOptions::layout); all panels have one camera.
///
/// Signs  those of femoop (femoop/result/curve.h); see results/diagram.h for the sides of diagrams
/// Speed  200 members with diagrams and values take a few milliseconds
void draw(ui::Painter& painter, const DrawInput& input, const DrawOptions& options, const DrawState& state = {});

/// The camera that shows everything: what `draw` uses when the state has none. An app takes it once, keeps it, and
/// moves it. It belongs to one panel: see `panels` in panels.h.
Camera fitted_camera(const DrawInput& input, const DrawOptions& options, ui::Size sheet, const ui::Fonts& fonts);

/// Whether a model is looked at from above its own plane (and so with an OrbitCamera) or in it.
bool is_seen_in_space(femoop::AnalysisKind kind);

/// The sheet's colour under the options' theme.
ui::Color background(const DrawOptions& options);

} // namespace drawing
