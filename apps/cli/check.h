#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona check`: reads model files and reports everything that is wrong with them, without solving.
std::unique_ptr<Subcommand> check_command();

} // namespace cli
