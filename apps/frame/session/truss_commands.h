#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// What is done with a plane truss that is worked out by hand.
void add_truss_commands(CommandTable& table);

/// The truss that the picture shows worked out; null where it shows none.
const TrussPicture* shown_truss(const Session& session);

std::string method_name(TrussMethod method, const ui::Catalogue& tr);

/// Why the truss that is asked for cannot be worked out so, as a sentence; empty where it can.
std::string why_no_truss_picture(const Session& session);

} // namespace frame
