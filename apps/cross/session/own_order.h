#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/cross/session/session.h"

namespace cross {

/// The joints in which a user balances, again and again: "B C B"; where names have blanks, "North end, South end".
std::string own_order(const Method& method);
/// Takes such an order. \returns why not: a name that is no joint, or none at all
std::optional<ui::Message> take_own_order(Session& session, std::string_view words);
/// Goes over to the order that was typed last, else to all joints as the file has them.
void choose_own_order(Session& session);

} // namespace cross
