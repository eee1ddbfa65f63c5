#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/mohr/session/session.h"

namespace mohr {

/// A result by its name, as panels and texts show it.
struct ResultLine {
    std::string name, value;
    std::optional<double> number{}; ///< with all its digits, where it is one number
    std::string unit{};
};
/// A group of results under a heading.
struct ResultGroup {
    std::string heading;
    std::vector<ResultLine> lines;
};
/// Everything that the state tells, in the session's language.
std::vector<ResultGroup> result_groups(const Session& session);

/// The same as a text, with the remarks on a special state.
std::string in_words(const Session& session);
/// The line at the window's foot.
std::string status_text(const Session& session);

} // namespace mohr
