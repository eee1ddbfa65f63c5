#pragma once

#include <Eigen/Core>
#include <optional>

#include "apps/drawing/results/solved_case.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/model/model.h"

namespace drawing {

/// The direction in which a support holds, where it holds in one alone and that is slanting: its reaction is one force in
/// that direction, of which fx and fy are the components. Nothing outside of a plane.
std::optional<Eigen::Vector3d> slanting_normal(const femoop::Model& model, femoop::NodeId node);

bool has_slanting_support(const femoop::Model& model);
/// Of fx and fy, without a sign.
double resultant(const femoop::NodeVector& reaction);

/// What the supports do to the structure: an arrow with its value for every component that is not zero, clear of the
/// support's symbol.
void draw_reactions(const Scene& scene, const SolvedCase& solved);

} // namespace drawing
