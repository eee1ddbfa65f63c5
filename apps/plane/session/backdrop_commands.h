#pragma once

#include "apps/plane/session/commands.h"

namespace plane {

/// The image behind the drawing: made paler, taken away. The tool that places it is among the others.
void add_backdrop_commands(CommandTable& table);
/// \returns why there is no backdrop to be placed
ui::Reason why_no_backdrop(const Workspace& workspace);
/// \pre there is a backdrop, and the opacity is from the least to 1
Change opacity_change(double opacity, Step step);

} // namespace plane
