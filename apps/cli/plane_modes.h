#pragma once

#include <optional>
#include <string>

#include "apps/cli/argument.h"
#include "ui/text/catalogue.h"

namespace cli {

inline constexpr long most_modes = 1000; ///< that --modes and --mode take

/// Of --analysis: linear, which is usual, or modal. \throws UsageError for another
bool asks_for_modes(const std::optional<std::string>& analysis, const ui::Catalogue& tr);

/// That structures of members have none yet.
UsageError modes_of_members(const ui::Catalogue& tr);

} // namespace cli
