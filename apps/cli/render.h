#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona render`: draws a model and its results to PNG, SVG or PDF, without a display.
std::unique_ptr<Subcommand> render_command();

} // namespace cli
