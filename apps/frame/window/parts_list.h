#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// All parts of the model by their kinds; a click selects one.
void parts_list(Desk& desk);

} // namespace frame
