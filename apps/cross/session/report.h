#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cross/session/commands.h"
#include "ui/text/refusal.h"

namespace cross {

/// Numbers in rows and columns with what is to be said of them, as panels and files show them.
struct TextTable {
    std::vector<std::string> notes; ///< sentences above it
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows; ///< each as long as the head
};

/// \pre the session has a task
TextTable table_of(const Session& session, Topic topic);
TextTable table_of(const Scene& scene, Topic topic);

std::string as_csv(const TextTable& table, ui::Language language); ///< with semicolons where the comma is decimal
std::string as_latex(const TextTable& table);

/// Every number of the automatic distribution, as `cremona cross` prints it; or why there is none.
std::string in_words(const Session& session);
/// That there is none: status 2 where the structure cannot be distributed, 3 where nothing resists its sways.
std::optional<ui::Refusal> why_no_words(const Session& session);
/// The line at the window's foot.
std::string status_text(const Session& session);

} // namespace cross
