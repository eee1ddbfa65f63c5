#pragma once

#include <string>

#include "ui/app/app.h"
#include "ui/app/app_options.h"

namespace ui {

/// Shows the app in a window of its own until it wants to quit; in a browser, which goes on by itself, it returns at once.
/// The files after the first one come as files do that are dropped on the window.
/// \pre the settings are complete. \throws ContextError where no window can be opened
void show_in_window(const AppOptions& options, const MakeApp& make);

} // namespace ui
