#pragma once

#include "apps/drawing/sketch/scene.h"

namespace drawing {

/// All supports, as textbooks draw them: which symbol follows from the blocked degrees of freedom.
///
///   plane models      ux uy rz   wall across the member        ux or uy       triangle on rollers
///   (support's axes)  ux uy      triangle on the ground        uy rz, ux rz   plate on rollers
///                     rz         plate on rollers both ways    springs        zigzag or spiral, with its stiffness
///   grillages, space  all        square plate                  translations   pyramid
///                     others     a cone along every blocked translation, a bar about every blocked rotation
///
/// A symbol stands where it hides the members least: below where it can.
void draw_supports(const Scene& scene);

/// Direction on the sheet in which a support's symbol lies, if the node has one that is drawn on one side.
std::optional<ui::Point> support_side(const Scene& scene, femoop::NodeId node);

/// The same in the model's axes.
std::optional<Eigen::Vector3d> support_side_in_model(const Scene& scene, femoop::NodeId node);

/// How far a support's symbol reaches from its node, in logical pixels.
double support_reach(const Sketch& sketch);

} // namespace drawing
