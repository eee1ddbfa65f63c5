#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona euler`: runs a script of Euler operators and prints what came out.
std::unique_ptr<Subcommand> euler_command();

} // namespace cli
