#pragma once

#include <optional>
#include <span>

#include "apps/frame/session/commands.h"

namespace frame {

/// "Why this number?": the player of the way from the data to a number, and its steps.
void add_derivation_commands(CommandTable& table);

/// Opens the player for a number of the results. \param of  its case; nothing: what is shown, of an envelope the one
/// that governs
void explain(Workspace& workspace, const PointedNumber& number);
/// Opens it for the force method with these redundants; none: those that the program chooses.
void explain_force_method(Workspace& workspace, std::span<const femoop::MovingEffect> redundants);
/// Closes the panel, where it shows one.
void close_derivation(Workspace& workspace);

} // namespace frame
