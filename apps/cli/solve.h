#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona solve`: analyses a model and prints its results as tables, JSON, CSV files, sentences or a member's trace.
std::unique_ptr<Subcommand> solve_command();

} // namespace cli
