#pragma once

#include "apps/frame/predict/prediction.h"
#include "apps/frame/view/results/diagram.h"
#include "apps/frame/view/sheet/panel_head.h"
#include "apps/frame/view/sketch/scene.h"

namespace frame {

/// Logical pixels of an ordinate as long as the model's unit of length, beside the true diagram: the largest guess is
/// as high as the largest moment of the members that it was made on. (As it was drawn it is the projection's own
/// scale.)
double guess_scale(const Scene& scene, const Prediction& prediction, const SolvedCase& solved, const Diagram& diagram);

/// Dashed lines over light areas, on the side where the moments of that sign are drawn; with an assessment the share of
/// each member that counts.
void draw_guess(const Scene& scene, const Prediction& prediction, double scale, const Assessment* assessment);

PanelHead guess_head(const Scene& scene, const Prediction& prediction, const Assessment* assessment);

} // namespace frame
