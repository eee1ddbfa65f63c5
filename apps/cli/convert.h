#pragma once

#include <memory>

#include "apps/cli/subcommand.h"

namespace cli {

/// `cremona convert`: writes a model in another form, chosen by the extension of the output.
std::unique_ptr<Subcommand> convert_command();

} // namespace cli
