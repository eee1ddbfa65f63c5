#pragma once

#include "apps/frame/session/session.h"

namespace frame {

/// The foot of the window: how large the structure is, how determinate, and its units.
void status_bar(const Session& session);

} // namespace frame
