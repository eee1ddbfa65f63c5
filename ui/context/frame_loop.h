#pragma once

#include <functional>

namespace ui {

/// Calls `step` until it is false. A browser calls it itself, whenever it draws a frame: there this returns before the
/// first one, so what the step works on is owned by the step.
void run_frames(std::function<bool()> step);

} // namespace ui
