#pragma once

#include <optional>
#include <string>

namespace ui {

/// A question with two answers; `no`, which changes nothing, stands first, and Escape means it.
struct YesOrNo {
    std::string heading, sentence; ///< translated, as are the answers
    std::string no, yes;
};

/// Asks over everything else; call it in every frame until it is answered.
std::optional<bool> ask_yes_or_no(const YesOrNo& question);

} // namespace ui
