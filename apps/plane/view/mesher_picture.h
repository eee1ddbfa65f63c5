#pragma once

#include <string>

#include "apps/plane/view/plate_scene.h"

namespace plane {

/// A mesh half way, as its player has it: cells that stand, those of the last step filled, the front or the squares of the
/// tree, the edge that was chosen, the place that was put in and the circle of the triangle that asked for it.
void draw_mesher(const PlateScene& scene);

/// "step 120 of 340  ·  R1: front"
std::string mesher_note(const discretize::MeshPlayer& player, const PlateOptions& options,
                        const femoop::plane::PlaneModel& model);
/// What the last step did, in a sentence; empty before the first.
std::string step_sentence(const discretize::MeshPlayer& player, const ui::Catalogue& tr);

/// The sentence at the sheet's foot, and how high the foot is.
double step_foot_height(const ui::Theme& theme);
void draw_step_foot(ui::Painter& painter, const std::string& sentence, const ui::Theme& theme, const ui::Box& room);

} // namespace plane
