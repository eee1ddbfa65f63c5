#pragma once

#include <memory>
#include <vector>

#include "apps/cli/subcommand.h"

namespace cli {

/// Every subcommand, in the order in which the help lists them.
std::vector<std::unique_ptr<Subcommand>> all_subcommands();

} // namespace cli
