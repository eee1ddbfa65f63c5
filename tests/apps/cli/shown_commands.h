#pragma once

#include <cstddef>
#include <string>

#include "tests/folder.h"

namespace cli_test {

/// Runs every command of a page's ```console blocks in the folder, where `examples` and `tests` are too, and checks
/// that it ends well and prints each line that the page shows below it. \returns how many there are
std::size_t run_shown_commands(const std::string& page, const Folder& folder);

} // namespace cli_test
