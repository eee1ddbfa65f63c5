#pragma once

#include "apps/drawing/sketch/scene.h"
#include "femoop/analysis/mechanism.h"

namespace drawing {

/// The structure in its free motion, with an arrow at every node that moves. Members stay straight, since nothing is
/// strained; the phase of the options moves it to and fro.
void draw_motion(const Scene& scene, const femoop::Mechanism& mechanism);

} // namespace drawing
