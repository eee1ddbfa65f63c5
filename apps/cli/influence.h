#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// cremona influence: influence lines of section forces, reactions and displacements.
std::unique_ptr<Subcommand> influence_command();

} // namespace cli
