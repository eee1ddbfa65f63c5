#include "femoop/edit/moved_parts.h"

#include "femoop/geometry/member_geometry.h"

namespace femoop {

namespace {

template <class Id> std::optional<Id> found(const std::unordered_map<std::string_view, Id>& ids, std::string_view name)
{
    const auto entry = ids.find(name);
    return entry != ids.end() ? std::optional(entry->second) : std::nullopt;
}

} // namespace

MovedParts::MovedParts(const Model& before) : before_(before)
{
    for (std::size_t i = 0; i < before.nodes.size(); ++i) nodes_.try_emplace(before.nodes[i].id, i);
    for (std::size_t i = 0; i < before.members.size(); ++i) members_.try_emplace(before.members[i].id, i);
}

std::optional<NodeId> MovedParts::former(const Node& node) const { return found(nodes_, node.id); }

std::optional<MemberId> MovedParts::former(const Member& member) const { return found(members_, member.id); }

bool MovedParts::is_moved(const Model& model, NodeId node) const
{
    const std::optional<NodeId> was = former(model[node]);
    return !was || position_of(before_, *was) != position_of(model, node);
}

bool MovedParts::is_moved(const Model& model, MemberId member) const
{
    const std::optional<MemberId> was = former(model[member]);
    if (!was) return true;
    const MemberGeometry then = geometry_of(before_, before_[*was]), now = geometry_of(model, model[member]);
    return then.start != now.start || then.end != now.end;
}

} // namespace femoop
