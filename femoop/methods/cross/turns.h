#pragma once

#include <optional>
#include <span>

#include "femoop/methods/cross/distribution.h"

namespace femoop::cross {

/// Whose turn it was: one joint's, or nothing: all joints at once.
using Turn = std::optional<JointId>;

/// The sheet of turns that a hand chose one by one, in any order, as far as they go.
/// \param procedure  its digits and tolerance; the rest of it means nothing here
Sheet sheet_of(const Problem& problem, const Loading& loading, std::span<const Turn> turns,
               const Procedure& procedure = {});

/// Whose turn would be next by an order; after a turn of their own, Order::LeftToRight and Order::Listed go on from it.
/// \pre the problem has joints
Turn next_turn(const Model& model, const Problem& problem, const Sheet& sheet, const Procedure& procedure);

} // namespace femoop::cross
