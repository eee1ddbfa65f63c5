#pragma once

#include <string>

#include "apps/euler/session/commands.h"

namespace euler {

/// The script's steps and every solid in words: counts, formula, whether it is sound.
std::string description(const Session& session);
/// The line at the window's foot.
std::string status_text(const Session& session);

} // namespace euler
