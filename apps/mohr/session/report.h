#pragma once

#include <string>
#include <vector>

#include "apps/mohr/session/session.h"
#include "femoop/tabular/table.h"

namespace mohr {

/// Everything that the state tells, in the session's language: a table for each group, titled, its columns the name,
/// the value with its unit as panels and texts show it, and the unit.
std::vector<tabular::Table> result_tables(const Session& session);

/// The same as a text, with the remarks on a special state.
std::string description(const Session& session);
/// The line at the window's foot.
std::string status_text(const Session& session);

} // namespace mohr
