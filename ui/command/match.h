#pragma once

#include <optional>
#include <string_view>

namespace ui {

/// Ranks up to this one are of names that have every typed word, in any order; others have but its letters.
inline constexpr int worst_rank_of_words = 4;

/// How well a typed text goes with a name: 0 where the name begins with its words, 1 where it begins with the text and
/// the last word goes on, 2 where every word of it is a word there, 3 where it begins one, 4 where it stands within
/// one, more the farther its letters are spread; nothing if the letters do not stand in the name in this order. Letter
/// case and the accents of Portuguese are ignored, so "acao" finds "Ação". An empty text goes with every name.
std::optional<int> match_rank(std::string_view typed, std::string_view name);

} // namespace ui
