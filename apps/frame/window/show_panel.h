#pragma once

#include "apps/frame/session/commands.h"
#include "apps/frame/window/case_list.h"
#include "ui/widgets/number_field.h"

namespace frame {

/// What is shown and how large: the load case, what the picture shows, the scales.
void show_panel(Workspace& workspace, const CommandTable& commands, CaseList& cases, ui::NumberFields& fields);

} // namespace frame
