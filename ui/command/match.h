#pragma once

#include <optional>
#include <string_view>

namespace ui {

/// How well a typed text goes with a name: 0 for the beginning of a word, more the farther its letters are spread;
/// nothing if the letters do not stand in the name in this order. Letter case and the accents of Portuguese are
/// ignored, so "acao" finds "Ação". An empty text goes with every name.
std::optional<int> match_rank(std::string_view typed, std::string_view name);

} // namespace ui
