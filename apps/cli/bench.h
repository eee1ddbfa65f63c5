#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona bench`: times the analysis of structures that are built in memory.
std::unique_ptr<Subcommand> bench_command();

} // namespace cli
