#pragma once

#include <string>
#include <vector>

#include "apps/plane/discretize/error_cycle.h"
#include "apps/plane/view/plate_picture.h"
#include "ui/text/message.h"

namespace plane {

/// What a cycle of refinement has brought, a sentence each: the meshes it went through, how fast the error falls, and
/// where evenly refined meshes show that stresses grow without bound.
std::vector<std::string> sentences(const discretize::ErrorCycle& cycle, const femoop::plane::PlaneModel& model,
                                   const PlateOptions& options);

/// Why a cycle goes no further. \pre there is no next mesh
ui::Message reason_of(const discretize::NextMesh& next, const discretize::ErrorCycle& cycle);

/// "5.2 %"; rounding is 0.
std::string percent_text(double share, const ui::NumberFormat& numbers);
/// "−0.97" of a rate of 0.97.
std::string exponent_text(double rate, const ui::NumberFormat& numbers);

/// The estimated error in percent against the unknowns of each mesh, both on logarithmic axes: meshes refined by the
/// error, meshes refined evenly, and the slope of smooth stresses. Beside it its sentences.
void draw_error_curve(ui::Painter& painter, const discretize::ErrorCycle& cycle, const femoop::plane::PlaneModel& model,
                      const PlateOptions& options, const ui::Box& box);

} // namespace plane
