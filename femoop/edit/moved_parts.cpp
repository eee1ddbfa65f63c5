#include "femoop/edit/moved_parts.h"

#include "femoop/geometry/member_geometry.h"

namespace femoop {

namespace {

template <class Id> std::optional<Id> found(const std::unordered_map<std::string_view, Id>& ids, std::string_view name)
{
    const auto entry = ids.find(name);
    return entry != ids.end() ? std::optional(entry->second) : std::nullopt;
}

/// A hint: most parts keep their number, and a look there is cheaper than a look-up.
template <class Part> bool is_at(const std::vector<Part>& parts, std::size_t number, std::string_view name)
{
    return number < parts.size() && parts[number].id == name;
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
    const std::optional<NodeId> was = is_at(before_.nodes, node.index, model[node].id) ? node : former(model[node]);
    return !was || position_of(before_, *was) != position_of(model, node);
}

bool MovedParts::is_moved(const Model& model, MemberId member) const
{
    const bool is_at_its_number = is_at(before_.members, member.index, model[member].id);
    const std::optional<MemberId> was = is_at_its_number ? member : former(model[member]);
    return !was || ends_of(before_, before_[*was]) != ends_of(model, model[member]);
}

} // namespace femoop
