#include "apps/cross/session/edit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "apps/cross/document/file.h"
#include "apps/frame/document/command.h"
#include "apps/frame/document/loading.h"
#include "femoop/model/check/check.h"

namespace cross {

using femoop::Model;
using femoop::NodeId;

namespace {

/// What the notes say of checks, from the sentence on that begins with it.
void drop_source_of_checks(std::string& notes)
{
    const std::size_t at = notes.find("Source of the checks:");
    if (at == std::string::npos) return;
    notes.erase(at);
    notes.erase(std::min(notes.size(), notes.find_last_not_of(" \n") + 1));
}

} // namespace

Model unverified(Model model)
{
    static const Document start = starting_document();
    if (model.title == start.model.title && model.notes == start.model.notes) {
        model.title.clear();
        model.notes.clear();
    }
    drop_source_of_checks(model.notes);
    model.expected.clear();
    std::erase_if(model.extra, [](const femoop::ExtraBlock& block) { return block.key == "cross"; });
    return model;
}

Eigen::Vector2d place_of(const Model& model, NodeId node)
{
    return {model[node].at[0].value(), model[node].at[1].value()};
}

bool is_level(const Model& model)
{
    return std::ranges::all_of(model.nodes, [&](const femoop::Node& node) {
        return std::abs(node.at[1].value() - model.nodes.front().at[1].value()) < 1e-9;
    });
}

bool is_sound(const Model& model) { return std::ranges::none_of(femoop::check(model), femoop::is_error); }

std::vector<femoop::MemberId> members_at(const Model& model, NodeId node)
{
    std::vector<femoop::MemberId> members;
    for (std::size_t m = 0; m < model.members.size(); ++m)
        if (std::ranges::count(model.members[m].nodes, node) > 0) members.emplace_back(m);
    return members;
}

NodeId far_node(const Model& model, femoop::MemberId member, NodeId node)
{
    const auto& nodes = model[member].nodes;
    return nodes[0] == node ? nodes[1] : nodes[0];
}

namespace {

/// On a beam no node is dragged past its neighbours.
bool keeps_order(const Model& before, NodeId node, double x)
{
    const double old = place_of(before, node).x();
    return std::ranges::all_of(members_at(before, node), [&](femoop::MemberId member) {
        const double neighbour = place_of(before, far_node(before, member, node)).x();
        return (neighbour < old) == (neighbour < x) && std::abs(neighbour - x) > 1e-6;
    });
}

} // namespace

std::optional<Model> with_node_at(const Model& model, NodeId node, Eigen::Vector2d place)
{
    Model next = unverified(model);
    const bool is_beam = is_level(model);
    if (is_beam && !keeps_order(model, node, place.x())) return std::nullopt;
    next.nodes[node.index].at[0] = femoop::Quantity(place.x());
    if (!is_beam) next.nodes[node.index].at[1] = femoop::Quantity(place.y());
    return is_sound(next) ? std::optional(std::move(next)) : std::nullopt;
}

Model with_load_scaled(const Model& model, const frame::Part& load, femoop::Dof dof, double factor)
{
    frame::Document document{.model = unverified(model)};
    frame::scale_load(document, load, dof, factor);
    return std::move(document.model);
}

std::optional<NodeId> end_node(const Model& model, Side side)
{
    if (model.nodes.empty()) return std::nullopt;
    const double sign = side == Side::Right ? 1.0 : -1.0;
    NodeId outermost{std::size_t{0}};
    for (std::size_t n = 1; n < model.nodes.size(); ++n)
        if (sign * place_of(model, NodeId(n)).x() > sign * place_of(model, outermost).x()) outermost = NodeId(n);
    return members_at(model, outermost).size() == 1 ? std::optional(outermost) : std::nullopt;
}

} // namespace cross
