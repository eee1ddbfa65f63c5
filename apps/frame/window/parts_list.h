#pragma once

#include "apps/frame/session/commands.h"
#include "apps/frame/window/property_sets.h"

namespace frame {

/// All parts of the model by their kinds; a click selects one.
void parts_list(Desk& desk, PropertySets& sets);

} // namespace frame
