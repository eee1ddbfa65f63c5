#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// What went wrong, over the picture: a notice, or the errors of the model.
void banner(Desk& desk);

} // namespace frame
