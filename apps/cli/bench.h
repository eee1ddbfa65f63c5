#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona bench`: times the analysis of structures, and the making of solids, in memory.
std::unique_ptr<Subcommand> bench_command();

} // namespace cli
