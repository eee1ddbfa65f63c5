#pragma once

#include <string>
#include <variant>

#include "apps/frame/session/commands.h"
#include "ui/desk/handover.h"

namespace frame {

/// What another program of the suite is started with, or why there is nothing to start it with.
using Offer = std::variant<ui::Handover, Notice>;

/// The selected members, or all where none is selected, for moment distribution, in the case that is shown.
Offer moment_distribution(const Session& session);
/// The nodes that are held fixed there, since selected members meet others at them: "B, D".
std::string held_nodes(const Session& session);

/// The section at the reading that is pinned or under the pointer, else where the only selected member has its largest
/// moment, in the case that is shown, at its hardest stressed fibre.
Offer circle_at_section(const Session& session);

void add_method_commands(CommandTable& table);

} // namespace frame
