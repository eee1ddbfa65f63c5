#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/frame/session/commands.h"
#include "ui/workspace/export_to_app.h"

namespace frame {

/// What another program of the suite is started with, or why there is nothing to start it with.
using Offer = std::variant<ui::ExportToApp, Notice>;

/// The selected members, or all where none is selected, for moment distribution, in the case that is shown.
Offer moment_distribution(const Session& session);
Offer moment_distribution(const Session& session, const std::vector<femoop::MemberId>& members,
                          femoop::CaseId load_case);
/// What of the structure it is given: these members alone, and nothing in faulty cases other than this one.
femoop::Model structure_handed(const Session& session, const std::vector<femoop::MemberId>& members,
                               femoop::CaseId load_case);
std::vector<femoop::MemberId> chosen_members(const Session& session); ///< that they would be
/// The nodes that are held fixed there, since selected members meet others at them: "B, D".
std::string held_nodes(const Session& session);

/// The section at the reading that is pinned or under the pointer, else where the only selected member has its largest
/// moment, in the case that is shown, at its hardest stressed fibre.
Offer circle_at_section(const Session& session);
Offer circle_at(const Session& session, const Cut& cut, femoop::CaseId load_case);
std::optional<Cut> cut_for_circle(const Session& session); ///< where it would be

/// "IPE 300", "rectangle b=90mm h=210mm", "IPE 300 turned"; nothing for a section of numbers alone.
std::optional<std::string> section_text(const femoop::Section& section, const femoop::Units& units);
/// The section with the profile or the shape of words such as "IPE 300" and "rectangle b=90mm h=210mm" in place of what
/// it has; nothing where they name none.
std::optional<femoop::Section> section_named(const std::string& words, const femoop::Section& section,
                                             const femoop::Units& units);

void add_method_commands(CommandTable& table);

} // namespace frame
