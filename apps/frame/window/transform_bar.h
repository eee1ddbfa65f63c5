#pragma once

#include "apps/frame/session/commands.h"
#include "ui/widgets/number_field.h"

namespace frame {

/// The numbers of the transformation that is under way, with its end: Enter or the button accepts, Esc gives up. The
/// first number has the keyboard at once; there the two keys take and drop what was typed first, if anything was. The
/// document shows at once what it does. \pre workspace.transform
void transform_bar(Workspace& workspace, ui::NumberFields& fields);

} // namespace frame
