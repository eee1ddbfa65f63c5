#include "apps/cross/session/drag_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/canvas/click.h"

namespace cross {

using femoop::MemberId;
using femoop::Model;
using ui::translatable;

namespace {

constexpr double off = 42.0;    // so far from a beam a support has left it
constexpr double beyond = 34.0; // of the sign from the end

double round_place(double x) { return std::round(10.0 * x) / 10.0; }

ui::Point on_sheet(const Drawn& drawn, femoop::NodeId node) { return drawn.nodes[node.index].at; }

/// The member that the pointer is on or just below, between its ends.
std::optional<SpanAim> span_at(const Model& model, const Drawn& drawn, ui::Point at, double scale)
{
    const double reach = 9.0 * scale, from_ends = 24.0 * scale;
    for (std::size_t m = 0; m < model.members.size(); ++m) {
        const auto& nodes = model.members[m].nodes;
        const ui::Point a = on_sheet(drawn, nodes[0]), b = on_sheet(drawn, nodes[1]);
        const double length = ui::distance(a, b);
        if (length < 2.0 * from_ends) continue;
        const ui::Point along = ui::direction(b - a);
        const double s = ui::dot(at - a, along), across = ui::dot(at - a, ui::left_normal(along));
        if (s < from_ends || s > length - from_ends || std::abs(across) > reach) continue;
        const Eigen::Vector2d first = place_of(model, nodes[0]), last = place_of(model, nodes[1]);
        const double x = round_place((last - first).norm() * s / length);
        if (!with_support_between(model, MemberId(m), x)) continue;
        return SpanAim{MemberId(m), x, a + (x / (last - first).norm()) * (b - a)};
    }
    return std::nullopt;
}

std::optional<Side> side_of(const Model& model, femoop::NodeId node)
{
    for (const Side side : {Side::Left, Side::Right})
        if (end_node(model, side) == node) return side;
    return std::nullopt;
}

/// The end has been dragged onto its neighbour, or past it.
bool has_met_neighbour(const Model& model, femoop::NodeId node, Side side, double x)
{
    const femoop::NodeId next = far_node(model, members_at(model, node).front(), node);
    const double neighbour = place_of(model, next).x();
    const double near = 0.08 * std::abs(neighbour - place_of(model, node).x());
    return side == Side::Right ? x < neighbour + near : x > neighbour - near;
}

} // namespace

std::optional<SpanAim> member_at(const Model& model, const Drawn& drawn, ui::Point at)
{
    constexpr double near = 20.0;
    if (drawn.nodes.size() != model.nodes.size() || !drawn.is_in_structure(at)) return std::nullopt;
    std::optional<SpanAim> nearest;
    double least = near;
    for (std::size_t m = 0; m < model.members.size(); ++m) {
        const auto& nodes = model.members[m].nodes;
        const ui::Point a = on_sheet(drawn, nodes[0]), b = on_sheet(drawn, nodes[1]), along = ui::direction(b - a);
        const double length = ui::distance(a, b), s = ui::dot(at - a, along);
        const double across = std::abs(ui::dot(at - a, ui::left_normal(along)));
        if (s <= 0.0 || s >= length || across >= least) continue;
        const double whole = (place_of(model, nodes[1]) - place_of(model, nodes[0])).norm();
        const double round = round_place(whole * s / length);
        const double x = round > 0.0 && round < whole ? round : whole * s / length;
        least = across;
        nearest = SpanAim{MemberId(m), x, a + (x / whole) * (b - a)};
    }
    return nearest;
}

std::optional<ui::Point> sign_beyond(const Model& model, const Drawn& drawn, Side side, double scale)
{
    const auto node = is_level(model) ? end_node(model, side) : std::nullopt;
    if (!node || node->index >= drawn.nodes.size()) return std::nullopt;
    const double away = side == Side::Right ? beyond : -beyond;
    const ui::Point sign = on_sheet(drawn, *node) + ui::Point{scale * away, 0.0};
    return drawn.is_in_structure(sign) ? std::optional(sign) : std::nullopt;
}

Aim aim_at(const Model& model, const Drawn& drawn, ui::Point at, double scale)
{
    if (drawn.nodes.size() != model.nodes.size() || !drawn.is_in_structure(at)) return {};
    if (const auto node = pick_node(drawn, at, 16.0 * scale)) return NodeAim{*node};
    for (const Side side : {Side::Left, Side::Right})
        if (const auto sign = sign_beyond(model, drawn, side, scale); sign && ui::distance(*sign, at) < 12.0 * scale)
            return EndAim{side, *sign};
    const drawing::LoadMark* const load = pick_load(drawn, at);
    const auto span = span_at(model, drawn, at, scale);
    constexpr double on_line = 3.0; // arrows end on the member
    if (span && (load == nullptr || at.y > span->at.y - on_line * scale)) return *span;
    if (load != nullptr) return LoadAim{*load};
    return {};
}

bool DragController::press(const Session& session, const Drawn& drawn, ui::Point at, double scale)
{
    const Model& model = session.document().model;
    Aim aim = aim_at(model, drawn, at, scale);
    if (std::holds_alternative<std::monostate>(aim)) return false;
    held_ = Held{.model = model, .aim = std::move(aim), .drawn = drawn, .pressed = at, .scale = scale};
    return true;
}

void DragController::pull(Session& session, ui::Point at)
{
    if (!held_ || (!held_->has_moved && ui::distance(at, held_->pressed) <= ui::click_reach)) return;
    held_->has_moved = true;
    std::visit([&](const auto& aim) { pull(session, aim, at); }, held_->aim);
}

void DragController::pull(Session& session, const NodeAim& aim, ui::Point at)
{
    const ui::World2 place = held_->drawn.in_structure(at);
    const bool is_beam = is_level(held_->model);
    const double away = std::abs(at.y - on_sheet(held_->drawn, aim.node).y);
    if (is_beam && held_->model[aim.node].support && away > off * held_->scale) {
        session.drag(with_support_taken(held_->model, aim.node), translatable("Take a support away"));
        return;
    }
    const auto side = is_beam ? side_of(held_->model, aim.node) : std::nullopt;
    if (side && has_met_neighbour(held_->model, aim.node, *side, place.x)) {
        if (auto next = with_span_removed(held_->model, *side))
            session.drag(std::move(*next), translatable("Remove the last span"));
        return;
    }
    if (auto next = with_node_at(held_->model, aim.node, {round_place(place.x), round_place(place.y)}))
        session.drag(std::move(*next), translatable("Move a support"));
}

void DragController::pull(Session& session, const LoadAim& aim, ui::Point at)
{
    const ui::Point arrow = aim.mark.tip - aim.mark.root, moved = at - held_->pressed;
    const double along = ui::dot(moved, arrow) / std::max(1.0, ui::dot(arrow, arrow));
    const ui::World2 from = held_->drawn.in_structure(held_->pressed), to = held_->drawn.in_structure(at);
    if (std::abs(ui::dot(moved, ui::left_normal(ui::direction(arrow)))) > std::abs(along) * ui::length(arrow)) {
        const double by = std::hypot(to.x - from.x, to.y - from.y) * (to.x < from.x ? -1.0 : 1.0);
        if (auto next = with_point_load_moved(held_->model, aim.mark.load, by)) {
            session.drag(std::move(*next), translatable("Move a load"));
            return;
        }
    }
    if (std::abs(1.0 + along) < 0.02) return; // a load of nothing has no arrow to pull
    Model next = with_load_scaled(held_->model, aim.mark.load, aim.mark.dof, 1.0 + along);
    if (next.load_cases == held_->model.load_cases) next = held_->model; // back to what it was
    session.drag(std::move(next), translatable("Pull a load"));
}

void DragController::pull(Session& session, const SpanAim& aim, ui::Point at)
{
    const auto& nodes = held_->model[aim.member].nodes;
    const ui::World2 place = held_->drawn.in_structure(at);
    const double x = std::abs(place.x - place_of(held_->model, nodes[0]).x());
    auto next = with_support_between(held_->model, aim.member, round_place(x)); // none beyond the member's ends
    session.drag(next ? std::move(*next) : held_->model, translatable("Put a support"));
}

void DragController::pull(Session& session, const EndAim& aim, ui::Point at)
{
    const femoop::NodeId end = *end_node(held_->model, aim.side);
    const double length = std::abs(held_->drawn.in_structure(at).x - place_of(held_->model, end).x());
    if (auto next = with_span_added(held_->model, aim.side, std::max(0.1, round_place(length))))
        session.drag(std::move(*next), translatable("Add a span"));
}

std::optional<femoop::NodeId> DragController::release(Session& session)
{
    const auto held = std::exchange(held_, std::nullopt);
    if (!held) return std::nullopt;
    if (held->has_moved) {
        session.settle();
        return std::nullopt;
    }
    if (const auto* const span = std::get_if<SpanAim>(&held->aim))
        if (auto next = with_support_between(held->model, span->member, span->x))
            session.change_later(std::move(*next), translatable("Put a support"));
    if (const auto* const end = std::get_if<EndAim>(&held->aim))
        if (auto next = with_span_added(held->model, end->side))
            session.change(std::move(*next), translatable("Add a span"));
    const auto* const node = std::get_if<NodeAim>(&held->aim);
    return node != nullptr ? std::optional(node->node) : std::nullopt;
}

void change_support(Session& session, femoop::NodeId node)
{
    session.change(with_next_support(session.document().model, node), translatable("Change a support"));
}

} // namespace cross
