#pragma once

#include "apps/drawing/view_options.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"
#include "ui/paint/painter.h"

namespace drawing {

/// Draws a structure with its loads and, where there are results, what they show, on the painter's whole sheet.
///
/// The drawing is a pure function of its arguments. Each result gets a panel of its own beside the loads and reactions
/// (ViewOptions::layout); all panels have one camera.
///
/// Signs  those of femoop (femoop/result/curve.h); see results/diagram.h for the sides of diagrams
/// Speed  200 members with diagrams and values take a few milliseconds
void draw(ui::Painter& painter, const femoop::Model& model, const femoop::Results* results, const ViewOptions& options);

/// Draws how a structure moves that cannot be solved, and says it in its sentence; of several motions, the one chosen.
void draw(ui::Painter& painter, const femoop::Model& model, const MotionChoice& motion, const ViewOptions& options);

/// The camera that shows everything: what `draw` uses when the options have none. An app takes it once, keeps it, and
/// moves it. It belongs to one panel: see `panels` in panels.h.
Camera fitted_camera(const femoop::Model& model, const femoop::Results* results, const ViewOptions& options,
                     ui::Size sheet, const ui::Fonts& fonts);

/// Whether a model is looked at from above its own plane (and so with an OrbitCamera) or in it.
bool is_seen_in_space(femoop::AnalysisKind kind);

/// The sheet's colour under the options' theme.
ui::Color background(const ViewOptions& options);

} // namespace drawing
