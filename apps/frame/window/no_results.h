#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Where results would stand: says why there are none to read, and offers hidden ones. \returns false where they can be
/// read
bool explain_no_results(Workspace& workspace);

/// The first error that leaves what is shown without results; null where it has some.
const femoop::Fault* why_not_solved(const Session& session);

/// A button that reveals the results; nothing where they are not hidden.
void offer_to_reveal(Workspace& workspace);

} // namespace frame
