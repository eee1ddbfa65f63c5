#pragma once

#include "apps/euler/view/subject.h"
#include "ui/canvas/orbit_camera.h"

#include <span>

namespace euler {

/// The camera, turned a little for no vertex to cover another or to lie on an edge that is not its own: on the sheet
/// they are then a twelfth of the picture apart, or a third of what they are apart in space. Where no direction does
/// that, one that comes near to it; the farther it turns the clearer it must get.
///
/// Misses   solids of thousands of vertices, which are seen as the camera stands
ui::OrbitCamera clear_view(const ui::OrbitCamera& camera, std::span<const Subject> subjects);

} // namespace euler
