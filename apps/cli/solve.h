#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona solve`: analyses a model and prints its results as tables, JSON, CSV files or sentences, or how a member
/// enters the system and how that is eliminated.
std::unique_ptr<Subcommand> solve_command();

} // namespace cli
