#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/mohr/session/session.h"
#include "femoop/tabular/table.h"

namespace mohr {

/// Everything that the state tells, in the session's language: a table for each group, titled, its columns the name,
/// the value with its unit as panels and texts show it, and the unit.
std::vector<tabular::Table> result_tables(const Session& session);

/// "σx = 50 MPa": a number of the state as it was typed, as it is printed in the session's language.
std::string given_number(const Session& session, std::size_t place);

/// What is given and the same tables as a text, with the remarks on a special state.
std::string description(const Session& session);
/// The line at the window's foot.
std::string status_text(const Session& session);

} // namespace mohr
