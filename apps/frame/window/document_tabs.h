#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// One tab for each document, where there are several: a click shows it, the middle button closes it.
void document_tabs(Workspace& workspace);

} // namespace frame
