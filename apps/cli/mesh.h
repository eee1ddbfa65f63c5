#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona mesh`: what the curves of a plane model's drawing divide the plane into, and the elements in it.
std::unique_ptr<Subcommand> mesh_command();

} // namespace cli
