#include "apps/cross/session/beam_edit.h"

#include <algorithm>
#include <cmath>

#include "apps/frame/document/command.h"
#include "femoop/edit/erase.h"
#include "femoop/edit/merge.h"
#include "femoop/edit/naming.h"
#include "femoop/edit/split.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/load/place_along.h"

namespace cross {

using femoop::Model;
using femoop::NodeId;
using femoop::SupportKind;

namespace {

void copy_loads(Model& model, femoop::MemberId from, femoop::MemberId to)
{
    for (femoop::LoadCase& load_case : model.load_cases) {
        const std::vector<femoop::MemberLoad> before = load_case.members;
        for (femoop::MemberLoad load : before) {
            if (load.member != from) continue;
            load.member = to;
            load_case.members.push_back(std::move(load));
        }
    }
}

/// Something else keeps the structure from gliding along.
bool is_held_along(const Model& model, NodeId but)
{
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        const auto& support = model.nodes[n].support;
        if (NodeId(n) != but && support && support->blocked(model.analysis).contains(femoop::Dof::ux)) return true;
    }
    return false;
}

double length_of(const Model& model, femoop::MemberId member)
{
    const auto& nodes = model[member].nodes;
    return (place_of(model, nodes[1]) - place_of(model, nodes[0])).norm();
}

} // namespace

std::optional<NodeId> end_of_spans(const Model& model, Side side)
{
    const auto end = end_node(model, side);
    if (!end) return std::nullopt;
    const NodeId before = far_node(model, members_at(model, *end).front(), *end);
    const Eigen::Vector2d along = place_of(model, *end) - place_of(model, before);
    return std::abs(along.y()) <= 1e-6 * along.norm() ? end : std::nullopt;
}

Model with_next_support(const Model& model, NodeId node)
{
    frame::Document document{.model = unverified(model)};
    const auto& support = model[node].support;
    const SupportKind first = is_held_along(model, node) && members_at(model, node).size() > 1 ? SupportKind::Roller
                                                                                               : SupportKind::Pin;
    if (!support) frame::set_support(document, node, first);
    else if (support->kind == SupportKind::Fixed) frame::set_support(document, node, std::nullopt);
    else frame::set_support(document, node, SupportKind::Fixed);
    return std::move(document.model);
}

std::optional<Model> with_support_between(const Model& model, femoop::MemberId member, double x)
{
    const auto& nodes = model[member].nodes;
    const double length = length_of(model, member), least = 0.02 * length;
    const Eigen::Vector2d along = place_of(model, nodes[1]) - place_of(model, nodes[0]);
    if (std::abs(along.y()) > 1e-6 * length || !(x > least && x < length - least)) return std::nullopt;
    Model next = unverified(model);
    const NodeId added = femoop::split_member(next, member, x).node;
    next.nodes[added.index].support = femoop::Support{.kind = SupportKind::Roller};
    return is_sound(next) ? std::optional(std::move(next)) : std::nullopt;
}

Model with_support_taken(const Model& model, NodeId node)
{
    Model next = unverified(model);
    next.nodes[node.index].support.reset();
    for (femoop::LoadCase& load_case : next.load_cases)
        std::erase_if(load_case.settlements, [&](const femoop::Settlement& one) { return one.node == node; });
    if (!femoop::why_not_merge_at(next, node)) femoop::merge_members_at(next, node);
    return next;
}

std::optional<Model> with_span_added(const Model& model, Side side, std::optional<double> length)
{
    const auto last = end_of_spans(model, side);
    if (!last) return std::nullopt;
    const femoop::MemberId span = members_at(model, *last).front();
    Eigen::Vector2d along = place_of(model, *last) - place_of(model, far_node(model, span, *last));
    if (length) along *= *length / along.norm();
    Model next = unverified(model);
    femoop::Node end = next[*last];
    end.id = femoop::fresh_node_id(next);
    for (std::size_t i = 0; i < 2; ++i)
        end.at[i] = femoop::Quantity(end.at[i].value() + along[static_cast<Eigen::Index>(i)]);
    const NodeId added = next.add(std::move(end));
    next.nodes[last->index].support = femoop::Support{.kind = SupportKind::Roller};
    if (!is_held_along(next, *last)) next.nodes[last->index].support->kind = SupportKind::Pin;
    femoop::Member member = next[span];
    const bool is_first = member.nodes[0] == *last; // the span runs away from this end
    member.nodes = is_first ? std::array{added, *last} : std::array{*last, added};
    member.id = femoop::fresh_member_id(next, member.nodes[0], member.nodes[1]);
    copy_loads(next, span, next.add(std::move(member)));
    return is_sound(next) ? std::optional(std::move(next)) : std::nullopt;
}

std::optional<Model> with_span_removed(const Model& model, Side side)
{
    const auto last = end_of_spans(model, side);
    if (!last || model.members.size() < 2) return std::nullopt;
    Model next = unverified(model);
    const NodeId before = far_node(model, members_at(model, *last).front(), *last);
    if (next[*last].support) next.nodes[before.index].support = next[*last].support;
    femoop::erase(next, {.nodes = {*last}});
    return is_sound(next) ? std::optional(std::move(next)) : std::nullopt;
}

std::optional<Model> with_point_load_moved(const Model& model, const frame::Part& load, double by)
{
    const auto* const place = std::get_if<frame::MemberLoadPlace>(&load);
    if (place == nullptr) return std::nullopt;
    Model next = unverified(model);
    femoop::MemberLoad& moved = next.load_cases[place->load_case].members[place->load];
    auto* const point = std::get_if<femoop::PointLoad>(&moved.load);
    if (point == nullptr) return std::nullopt;
    const double length = length_of(model, moved.member), step = 0.1;
    const double x = step * std::round((femoop::written_place(point->at, length) + by) / step);
    if (!(x > 0.0 && x < length)) return std::nullopt;
    point->at = femoop::Quantity(x);
    return is_sound(next) ? std::optional(std::move(next)) : std::nullopt;
}

} // namespace cross
