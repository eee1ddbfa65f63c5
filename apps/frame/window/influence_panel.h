#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// At the left while an influence line is shown, in place of cases and results: what the line is of, and its train.
void influence_choices(Workspace& workspace, const CommandTable& commands);

/// At the right in place of the results of a case: the line in numbers, and of a train on it every candidate position
/// with its value; a click on one sets the train there. \pre an influence line is shown
void influence_panel(Workspace& workspace);

} // namespace frame
