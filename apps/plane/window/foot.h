#pragma once

#include <optional>

#include "apps/plane/session/commands.h"
#include "ui/widgets/panel.h"

namespace plane {

/// What is told of the drawing as a whole at the window's foot: two regions that claim one face, else the gap of an open
/// outline, while nothing is being drawn, else why results that are to be seen are not there. Nothing where all is well.
std::optional<ui::FootMessage> foot_of(const Workspace& workspace);
/// A button of it, or its line, which does what the first button does.
void answer_foot(Workspace& workspace, const CommandTable& commands, std::size_t pressed);

} // namespace plane
