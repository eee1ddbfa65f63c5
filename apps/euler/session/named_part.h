#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "apps/euler/session/session.h"

namespace euler {

/// The entity that words name: "vertex v1", "edge v1 v2", "half-edge v1 v2", "face f1", each also after the name of its
/// solid: "s2 face f1". The first that fits; nothing where none does.
std::optional<Part> named_part(std::span<const Snapshot> solids, std::string_view words);

} // namespace euler
