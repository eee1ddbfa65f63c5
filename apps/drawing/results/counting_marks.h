#pragma once

#include "apps/drawing/sketch/scene.h"
#include "femoop/methods/counting/counting.h"

namespace drawing {

/// Each term of the degree of indeterminacy where it comes from: a number in the middle of each ring of members with
/// the forces that it adds, at joints what they release, at supports the reactions.
void draw_counting(const Scene& scene, const femoop::counting::Counting& counting);

} // namespace drawing
