#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/text/message.h"

namespace ui {

/// Why something cannot be done, as a sentence; nothing where it can.
using Reason = std::optional<Message>;

/// What a scenario writes behind the name of a command: `plane.turn 30`.
struct Argument {
    std::string_view id; ///< of the command
    std::string_view text;

    std::vector<std::string> words() const;
    std::optional<double> number() const; ///< nothing for what is no number
    /// So many numbers, with or without commas and brackets: "(2, 0)". Nothing for what is something else.
    std::optional<std::vector<double>> numbers(std::size_t count) const;

    /// Why it is refused: what was found, and what was wanted. \param what  "an angle in degrees"
    Message wanted(std::string_view what) const;
};

} // namespace ui
