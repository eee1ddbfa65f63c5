#pragma once

#include <string>

#include "apps/cli/console.h"

namespace cli {

/// Runs every entry of a file of states (tests/states/published.json) and compares what it expects: a line each,
/// then the count; in JSON as `verify --json`. \returns No if a check failed \throws UsageError naming the entry
ExitStatus run_mohr_cases(const std::string& file, bool is_json, Console& console);

} // namespace cli
