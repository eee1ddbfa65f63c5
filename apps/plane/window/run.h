#pragma once

#include "ui/app/app_options.h"

namespace plane {

/// Runs the app as the options say: in a window, for one screenshot, or through a scenario. The exit status: 0 done,
/// 1 a scenario did not go as it expects, 2 bad input or no display.
int run(const ui::AppOptions& options);

} // namespace plane
