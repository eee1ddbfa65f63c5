#pragma once

#include <string>

#include "apps/frame/session/commands.h"
#include "apps/frame/window/case_list.h"
#include "ui/widgets/number_field.h"

namespace frame {

/// What is shown and how large: the load case, what the picture shows, the scales.
void show_panel(Workspace& workspace, const CommandTable& commands, CaseList& cases, ui::NumberFields& fields);

/// Stands over a part of that panel.
void panel_heading(const std::string& text);

} // namespace frame
