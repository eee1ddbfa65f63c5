#pragma once

#include <functional>

#include "apps/frame/session/commands.h"

namespace frame {

/// One tab for each document, where there are several: a click shows it, the middle button closes it.
/// \param may_leave  the document that is shown
void document_tabs(Workspace& workspace, const std::function<bool()>& may_leave);

} // namespace frame
