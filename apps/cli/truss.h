#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// cremona truss: a plane truss by hand, joint by joint, by a section, or by its Cremona diagram.
std::unique_ptr<Subcommand> truss_command();

} // namespace cli
