#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona compare`: results beside those of another load case or another file, with the changes.
std::unique_ptr<Subcommand> compare_command();

} // namespace cli
