#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona cross`: the moment-distribution sheet of a structure, row by row.
std::unique_ptr<Subcommand> cross_command();

} // namespace cli
