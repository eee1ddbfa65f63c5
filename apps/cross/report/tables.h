#pragma once

#include "apps/cross/view/scene.h"
#include "femoop/tabular/table.h"

#include <cstdint>

namespace cross {

/// What the panel at the right shows.
enum class Topic : std::uint8_t { Sheet, Comparison, Sways, Convergence, Kani, Equations, Exercises };

/// Numbers in rows and columns with what is to be said of them, as panels and files show them; empty for exercises, which
/// a session has. \pre the scene has a task
tabular::Table table_of(const Scene& scene, Topic topic);

} // namespace cross
