#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "apps/cross/session/session.h"
#include "apps/frame/document/number.h"

namespace cross {

/// A length between two neighbouring levels of nodes: across (axis 0) or upwards (1).
struct Level {
    int axis = 0;
    double low = 0.0, high = 0.0;
    friend bool operator==(const Level&, const Level&) = default;
};

/// What stands in the picture of the structure and can be typed: the value of a load, a length, the E I of a member.
using TypedValue = std::variant<frame::NumberId, Level, femoop::MemberId>;

/// The value that is written there.
std::optional<TypedValue> written_at(const Session& session, const Drawn& drawn, ui::Point at);
/// The same, or the nearest that a finger there would cover, or that of the load whose arrows are there.
std::optional<TypedValue> value_at(const Session& session, const Drawn& drawn, ui::Point at);

/// What a field begins with: nothing is lost where it is confirmed as it stands.
std::string text_of(const Session& session, const TypedValue& value);

/// The structure with what was typed, or why not: with a unit or without, or a small calculation; an E I also as a
/// multiple of the smallest, "2 EI". A load keeps its sense unless a minus turns it; one of 0 goes. What lies beyond a
/// length moves along.
std::variant<femoop::Model, ui::Message> with_value(const Session& session, const TypedValue& value,
                                                    std::string_view text);

/// A load of a usual size, and the number of it that can be typed.
struct NewLoad {
    femoop::Model model;
    frame::NumberId number;
};
/// Downwards: along the member, or at x from its first end.
NewLoad with_uniform_load(const Session& session, femoop::MemberId member);
NewLoad with_point_load(const Session& session, femoop::MemberId member, double x);
/// On a beam downwards, on a frame inwards from the node's side.
NewLoad with_node_load(const Session& session, femoop::NodeId node);

} // namespace cross
