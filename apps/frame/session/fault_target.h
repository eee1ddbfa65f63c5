#pragma once

#include "apps/frame/session/commands.h"
#include "femoop/model/fault/fault.h"

namespace frame {

/// Goes to where a fault of the document is mended: shows its case, selects the part that it is about, and opens the
/// table with the cell of the field. What the fault has none of stays as it is.
void go_to(Workspace& workspace, const femoop::Fault& fault);

} // namespace frame
