#include "apps/frame/tools/select_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "apps/frame/document/command.h"
#include "apps/frame/document/dimensioning.h"
#include "apps/frame/document/drawing.h"
#include "apps/frame/document/loading.h"
#include "apps/frame/tools/dimension_tool.h"
#include "apps/frame/tools/snap.h"
#include "femoop/edit/member_line.h"
#include "femoop/geometry/node_position.h"
#include "ui/text/catalogue.h"

namespace frame {

using Eigen::Vector2d;
using femoop::Model;
using ui::Point;
using ui::translatable;

namespace {

/// A rectangle on the sheet.
struct Window {
    Vector2d least, most;

    Window(Point a, Point b)
        : least(std::min(a.x, b.x), std::min(a.y, b.y)), most(std::max(a.x, b.x), std::max(a.y, b.y))
    {}
    bool contains(const Vector2d& p) const
    {
        return (p.array() >= least.array()).all() && (p.array() <= most.array()).all();
    }
    /// A part of the line lies inside (Liang and Barsky's clipping).
    bool meets(const Vector2d& a, const Vector2d& b) const
    {
        double enters = 0.0, leaves = 1.0;
        for (int i = 0; i < 2; ++i) {
            const double run = b[i] - a[i];
            if (run == 0.0 && (a[i] < least[i] || a[i] > most[i])) return false;
            if (run == 0.0) continue;
            const double t = (least[i] - a[i]) / run, u = (most[i] - a[i]) / run;
            enters = std::max(enters, std::min(t, u));
            leaves = std::min(leaves, std::max(t, u));
        }
        return enters <= leaves;
    }
};

// Whole degrees in (-180, 180], drawn to multiples of 15.
double round_angle(double degrees, bool is_exact)
{
    constexpr double step = 15.0, reach = 4.0;
    const double near = step * std::round(degrees / step);
    const double round = !is_exact && std::abs(degrees - near) <= reach ? near : std::round(degrees);
    return round - 360.0 * std::ceil((round - 180.0) / 360.0);
}

/// The line of the member that a load acts on. \pre it acts on one
femoop::MemberLine line_of_load(const Model& model, const Part& load)
{
    const auto place = std::get<MemberLoadPlace>(load);
    return line_of(model, model[model.load_cases.at(place.load_case).members.at(place.load).member]);
}

} // namespace

std::optional<Change> SelectTool::press(const Work& work, const Aim& at)
{
    start_ = now_ = at;
    is_dragging_ = false;
    const std::optional<Part> part = at.part();
    gesture_ = gesture_at(at);
    was_selected_ = part && work.selection.contains(*part);
    if (!part || gesture_ == Gesture::Window) return std::nullopt;
    if (at.adds) work.selection.add(*part);
    else if (!was_selected_) work.selection = *part;
    grabbed_ = work.selection;
    if (gesture_ == Gesture::Move) moving_ = nodes_of(work.document.model, grabbed_.parts());
    return std::nullopt;
}

std::optional<Change> SelectTool::move(const Work& work, const Aim& to)
{
    if (gesture_ == Gesture::None) return std::nullopt;
    now_ = to;
    if (!is_dragging_ && to.is_dragged_from(start_)) {
        is_dragging_ = true;
        if (gesture_ == Gesture::Pull && goes_along_member(work.document.model, to)) gesture_ = Gesture::Carry;
    }
    if (!is_dragging_) return std::nullopt;
    if (gesture_ == Gesture::Move) return moved(work, to);
    if (gesture_ == Gesture::Pull) return pulled(work, to);
    if (gesture_ == Gesture::Carry) return carried(work, to);
    if (gesture_ == Gesture::Turn) return turned(work, to);
    if (gesture_ == Gesture::Slide) return slid(work, to);
    return std::nullopt;
}

SelectTool::Gesture SelectTool::gesture_at(const Aim& at) const
{
    if (!at.may_drag()) return Gesture::Window;
    if (at.node || at.cut) return Gesture::Move;
    if (at.points_at_support()) return Gesture::Turn;
    if (at.dimension) return Gesture::Slide;
    return at.grip ? Gesture::Pull : Gesture::Window;
}

Change SelectTool::moved(const Work& work, const Aim& to) const
{
    const Vector2d anchor = start_.node ? place_of(work.document.model, *start_.node) : start_.snap.place;
    const Vector2d shift = to.snap.place - anchor;
    const std::vector<Part> parts(grabbed_.parts().begin(), grabbed_.parts().end());
    const ui::Message label = grabbed_.only() ? ui::Message(translatable("Move: {part}"),
                                                            {{"part", title(work.document, parts.front())}})
                                              : ui::Message(translatable("Move the selection"));
    return {label,
            [=, crossings = to.crossings()](Document& changed) {
                const Model before = changed.model;
                place(changed, parts, femoop::moved_by({shift.x(), shift.y(), 0.0}));
                join(changed, before, {.crossings = crossings});
            },
            Step::Drag};
}

Change SelectTool::pulled(const Work& work, const Aim& to) const
{
    const LoadGrip& grip = *start_.grip;
    const double factor = 1.0 + (to.pointer - start_.pointer).dot(grip.pull) / grip.pull.squaredNorm();
    return {{translatable("Change the value: {part}"), {{"part", title(work.document.model, grip.load)}}},
            [=](Document& changed) { scale_load(changed, grip.load, grip.dof, factor); },
            Step::Drag};
}

/// The hand that has taken hold of a point load goes rather along its member than along its arrow.
bool SelectTool::goes_along_member(const Model& model, const Aim& to) const
{
    if (!place_of_load(model, start_.grip->load)) return false;
    const Vector2d way = to.pointer - start_.pointer;
    const auto along = [&](const Vector2d& direction) { return std::abs(way.dot(direction)); };
    return along(line_of_load(model, start_.grip->load).direction.head<2>()) > along(start_.grip->pull.normalized());
}

Change SelectTool::carried(const Work& work, const Aim& to) const
{
    constexpr double spacing = 8.0; // [px] of the round places
    const Model& model = work.document.model;
    const femoop::MemberLine line = line_of_load(model, start_.grip->load);
    const double step = round_grid(spacing * to.pixel);
    const double meant = *place_of_load(model, start_.grip->load) +
                         (to.pointer - start_.pointer).dot(line.direction.head<2>());
    const double x = std::clamp(to.is_exact ? meant : step * std::round(meant / step), 0.0, line.length);
    return {{translatable("Move: {part}"), {{"part", title(model, start_.grip->load)}}},
            [load = start_.grip->load, x](Document& changed) { place_load(changed, load, x); },
            Step::Drag};
}

Change SelectTool::turned(const Work& work, const Aim& to) const
{
    const SupportGrip& grip = *start_.support;
    const Model& model = work.document.model;
    const Vector2d arm = to.pointer - place_of(model, grip.node);
    const double angle = round_angle(model[grip.node].support->angle + direction_of(arm) - grip.angle, to.is_exact);
    return {{translatable("Turn: {part}"), {{"part", title(model, grip.node)}}},
            [=](Document& changed) { set_support_angle(changed, grip.node, angle); },
            Step::Drag};
}

Change SelectTool::slid(const Work& work, const Aim& to) const
{
    const DimensionPlace place = *start_.dimension;
    const DimensionLine& line = work.document.companion.dimensions.at(place.dimension);
    const double offset = offset_meant(offset_through(work.document.model, line, to.pointer).value_or(line.offset), to);
    return {{translatable("Move: {part}"), {{"part", title(work.document, place)}}},
            [=](Document& changed) { set_offset(changed, place, offset); },
            Step::Drag};
}

std::optional<Change> SelectTool::release(const Work& work, const Aim& at)
{
    const Gesture gesture = std::exchange(gesture_, Gesture::None);
    const bool was_dragged = std::exchange(is_dragging_, false);
    now_ = at;
    moving_.clear();
    const std::optional<Part> part = start_.part();
    if (gesture == Gesture::Window && (was_dragged || !part)) {
        if (!at.adds) work.selection.clear();
        if (was_dragged) select_window(work);
        return std::nullopt;
    }
    if (!part || gesture == Gesture::None) return std::nullopt;
    if (!was_dragged) {
        if (at.adds && (was_selected_ || gesture == Gesture::Window)) work.selection.toggle(*part);
        if (!at.adds) work.selection = *part;
        return std::nullopt;
    }
    if (gesture == Gesture::Pull) return pulled(work, at);
    if (gesture == Gesture::Carry) return carried(work, at);
    if (gesture == Gesture::Turn) return turned(work, at);
    if (gesture == Gesture::Slide) return slid(work, at);
    return moved(work, at);
}

void SelectTool::select_window(const Work& work) const
{
    const Model& model = work.document.model;
    const Window window(start_.on_sheet, now_.on_sheet);
    const bool must_lie_inside = now_.on_sheet.x >= start_.on_sheet.x;
    const auto seen = [&](femoop::NodeId node) {
        const Point at = now_.projection(femoop::position_of(model, node));
        return Vector2d(at.x, at.y);
    };
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if (window.contains(seen(femoop::NodeId(i)))) work.selection.add(femoop::NodeId(i));
    for (std::size_t i = 0; i < model.members.size(); ++i) {
        const Vector2d a = seen(model.members[i].nodes[0]), b = seen(model.members[i].nodes[1]);
        const bool is_in = must_lie_inside ? window.contains(a) && window.contains(b) : window.meets(a, b);
        if (is_in) work.selection.add(femoop::MemberId(i));
    }
}

bool SelectTool::escape()
{
    is_dragging_ = false;
    moving_.clear();
    return std::exchange(gesture_, Gesture::None) != Gesture::None;
}

Preview SelectTool::preview() const
{
    if (gesture_ != Gesture::Window || !is_dragging_) return {};
    return {.lines = {}, .window = std::pair(start_.on_sheet, now_.on_sheet)};
}

} // namespace frame
