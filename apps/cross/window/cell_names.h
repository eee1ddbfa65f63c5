#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "apps/cross/session/session.h"

namespace cross {

/// A cell of the sheet that is seen, as scenarios name it, and how many words its name has:
///
///     cell stiffness BA    cell factor BA    cell fixed-end BA    cell sum BA    cell final BA
///     cell balance 1 BA    cell carry-over 1 AB                   the turn, then the end
///     cell holding 0       of the first prop in the sheet of the loads
///     cell multiplier      of the first sway
struct NamedCell {
    femoop::cross::BlankId cell;
    std::size_t n_words = 0;
};
std::optional<NamedCell> cell_named(const Session& session, const std::vector<std::string>& words);

} // namespace cross
