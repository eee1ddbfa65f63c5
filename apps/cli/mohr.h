#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona mohr`: Mohr's circle of a state, or of every state of a file of cases.
std::unique_ptr<Subcommand> mohr_command();

} // namespace cli
