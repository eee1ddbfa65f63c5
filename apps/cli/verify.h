#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona verify`: compares what a model's file expects with what the analysis finds.
std::unique_ptr<Subcommand> verify_command();

} // namespace cli
