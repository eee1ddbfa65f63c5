#pragma once

#include <string>
#include <vector>

#include "apps/cli/exit_status.h"

namespace cli {

/// Runs `cremona` with these arguments (without the program's name): results to stdout, messages to stderr. Where they ask for
/// an app, the program becomes that app.
/// \param version  what `--version` prints behind the name
ExitStatus run(const std::vector<std::string>& arguments, const std::string& version = {});

} // namespace cli
