#pragma once

#include "apps/frame/session/commands.h"
#include "apps/frame/window/property_sets.h"
#include "apps/frame/window/title_rows.h"

namespace frame {

/// What the whole model has, and all its parts by their kinds; a click selects one.
void parts_list(Workspace& workspace, PropertySets& sets, TitleRows& title);

} // namespace frame
