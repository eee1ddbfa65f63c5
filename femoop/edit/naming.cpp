#include "femoop/edit/naming.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <unordered_set>

namespace femoop {

namespace {

std::optional<std::uint32_t> number_in(std::string_view name)
{
    std::uint32_t number = 0;
    const char* const end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data(), end, number);
    return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// One more than the largest, if the list holds numbers alone.
template <class List> std::optional<std::string> next_number(const List& list)
{
    std::uint32_t largest = 0;
    for (const auto& entry : list) {
        const std::optional<std::uint32_t> number = number_in(entry.id);
        if (!number) return std::nullopt;
        largest = std::max(largest, *number);
    }
    if (list.empty()) return std::nullopt;
    return std::to_string(largest + 1);
}

template <class List> std::unordered_set<std::string_view> names_of(const List& list)
{
    std::unordered_set<std::string_view> names;
    for (const auto& entry : list) names.insert(entry.id);
    return names;
}

/// Leaves those alone whose names the other list has.
template <class List> void forget_new(List& list, const List& before)
{
    const std::unordered_set<std::string_view> names = names_of(before);
    std::erase_if(list, [&](const auto& entry) { return !names.contains(entry.id); });
}

} // namespace

std::string fresh_name(const std::string& wanted, const std::function<bool(const std::string&)>& is_taken)
{
    if (!is_taken(wanted)) return wanted;
    const std::size_t digits = wanted.find_last_not_of("0123456789") + 1;
    const std::uint32_t first = number_in(std::string_view(wanted).substr(digits)).value_or(1) + 1;
    for (std::uint32_t number = first;; ++number) {
        std::string name = wanted.substr(0, digits) + std::to_string(number);
        if (!is_taken(name)) return name;
    }
}

std::string fresh_node_id(const Model& model)
{
    if (std::optional<std::string> number = next_number(model.nodes)) return *number;
    const std::unordered_set<std::string_view> taken = names_of(model.nodes);
    for (int round = 0;; ++round) {
        for (char letter = 'A'; letter <= 'Z'; ++letter) {
            std::string name = letter + (round == 0 ? std::string() : std::to_string(round));
            if (!taken.contains(name)) return name;
        }
    }
}

std::string fresh_member_id(const Model& model, NodeId start, NodeId end)
{
    if (std::optional<std::string> number = next_number(model.members)) return *number;
    const std::unordered_set<std::string_view> taken = names_of(model.members);
    const bool are_numbers = number_in(model[start].id) || number_in(model[end].id);
    const std::string joined = model[start].id + (are_numbers ? "-" : "") + model[end].id;
    std::string name = model.members.empty() && are_numbers ? "1" : joined;
    for (int round = 2; taken.contains(name); ++round) name = joined + '\'' + std::to_string(round);
    return name;
}

std::string fresh_id(const std::vector<Material>& taken, const std::string& wanted)
{
    return fresh_name(wanted,
                      [&](const std::string& name) { return std::ranges::count(taken, name, &Material::id) > 0; });
}

std::string fresh_id(const std::vector<Section>& taken, const std::string& wanted)
{
    return fresh_name(wanted,
                      [&](const std::string& name) { return std::ranges::count(taken, name, &Section::id) > 0; });
}

std::string fresh_case_id(const Model& model, const std::string& wanted)
{
    return fresh_name(wanted, [&](const std::string& name) { return model.find_case(name).has_value(); });
}

bool is_named_after_nodes(const Model& model, const Member& member)
{
    return member.id == model[member.nodes[0]].id + model[member.nodes[1]].id;
}

void rename(Model& model, const Model& before)
{
    Model named = model;
    forget_new(named.nodes, before.nodes);
    forget_new(named.members, before.members);
    const std::unordered_set<std::string_view> old_nodes = names_of(before.nodes),
                                               old_members = names_of(before.members);
    for (Node& node : model.nodes) {
        if (old_nodes.contains(node.id)) continue;
        node.id = fresh_node_id(named);
        named.nodes.push_back(node);
    }
    named.nodes = model.nodes; // in the order that members refer to
    for (Member& member : model.members) {
        if (old_members.contains(member.id)) continue;
        member.id = fresh_member_id(named, member.nodes[0], member.nodes[1]);
        named.members.push_back(member);
    }
}

} // namespace femoop
