#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// cremona train: moving loads and their envelopes.
std::unique_ptr<Subcommand> train_command();

} // namespace cli
