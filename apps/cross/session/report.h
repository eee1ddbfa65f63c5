#pragma once

#include <optional>
#include <string>

#include "apps/cross/session/commands.h"
#include "femoop/tabular/separated.h"
#include "ui/text/refusal.h"

namespace cross {

/// The same of what is open, with its exercises; blanks while an exercise hides the results.
tabular::Table table_of(const Session& session, Topic topic);

/// Of a file of separated values: semicolons where the comma is decimal.
tabular::Separators separators(ui::Language language);

/// Every number of the automatic distribution, as `cremona cross` prints it; or why there is none.
std::string description(const Session& session);
/// That there is none: status 2 where the structure cannot be distributed, 3 where nothing resists its sways.
std::optional<ui::Refusal> why_no_words(const Session& session);
/// The line at the window's foot.
std::string status_text(const Session& session);

} // namespace cross
