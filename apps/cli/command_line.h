#pragma once

#include <string>
#include <vector>

#include "apps/cli/exit_status.h"

namespace cli {

/// Runs `cremona` with these arguments (without the program's name): results to stdout, messages to stderr.
ExitStatus run(const std::vector<std::string>& arguments);

} // namespace cli
