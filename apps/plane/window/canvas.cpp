#include "apps/plane/window/canvas.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "apps/drawing/grid.h"
#include "apps/mohr/view/stress_circle.h"
#include "apps/plane/document/erase.h"
#include "apps/plane/document/outlines.h"
#include "apps/plane/document/points.h"
#include "apps/plane/session/drawing_commands.h"
#include "apps/plane/window/hand_picture.h"
#include "ui/canvas/click.h"

namespace plane {

using ui::translatable;

namespace {

constexpr double snap_reach = 10.0; // [px]
constexpr double pick_reach = 7.0;  // [px]

/// There is nothing to be seen of it.
bool is_empty(const Session& session)
{
    const bool has_backdrop = session.look.backdrop && session.document().backdrop;
    return session.model().points.empty() && session.model().curves.empty() && !has_backdrop;
}

/// Loads on points and curves that are not nothing, of the case that is shown; of a combination, those of all cases.
std::ptrdiff_t n_drawn_loads(const Session& session)
{
    using femoop::plane::Field;
    const auto is_given = [](const std::optional<Field>& field) {
        return field && *field != Field{femoop::Quantity(0.0)};
    };
    const auto is_drawn = [&](const femoop::plane::CurveLoad& load) {
        return is_given(load.qx) || is_given(load.qy) || is_given(load.value);
    };
    const auto& cases = session.model().load_cases;
    std::ptrdiff_t n = 0;
    for (std::size_t i = 0; i < cases.size(); ++i)
        if (i == session.load_case || session.load_case >= cases.size())
            n += std::ssize(cases[i].points) + std::ranges::count_if(cases[i].curves, is_drawn);
    return n;
}

/// Whether a sheet has become another one by lines of the window's foot, which come and go.
bool is_line_of_foot(ui::Size before, ui::Size now)
{
    constexpr double most_lines = 4.0;
    const auto line = static_cast<double>(ImGui::GetTextLineHeightWithSpacing());
    return before.width == now.width && std::abs(before.height - now.height) < most_lines * line;
}

bool is_finite(const FlatPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

} // namespace

void Canvas::show(Workspace& workspace, ui::ImGuiSession& gui)
{
    if (!begin(gui, any_button)) return;
    workspace.session.analyse_what_is_shown();
    fit_if_needed(workspace);
    if (workspace.session.camera) camera_ = *workspace.session.camera;
    follow(workspace);
    workspace.session.analyse_what_is_shown(); // the hand may have changed the document
    paint([&](ui::Painter& painter) { room_ = paint_all(workspace, painter); });
    margin_ = ui::Point{sheet().width, sheet().height} - room_.max;
    if (!fitted_margin_) fitted_margin_ = margin_;
    end(gui);
}

// ---- the view

void Canvas::fit(Session& session)
{
    session.camera.reset();
    fitted_for_.reset();
}

void Canvas::zoom(Session& session, double factor) const
{
    ui::PlaneCamera changed = camera_;
    changed.zoom(middle(), factor);
    session.camera = changed;
}

ui::PlaneCamera Canvas::usual_camera(const Session& session) const
{
    if (!is_empty(session)) return fitted_camera(session.input(), session.options(), sheet(), fonts());
    const double scale = sheet().width / usual_width(session.model());
    return {{0.1 * sheet().width, 0.85 * sheet().height}, scale};
}

// Drawing must not move the picture under the hand: it moves where something else is opened, or where with no tool in
// the hand a part is out of sight.
void Canvas::fit_if_needed(const Workspace& workspace)
{
    const Session& session = workspace.session;
    if (session.camera) {
        fitted_for_.reset();
        return;
    }
    const PlateOptions options = session.options();
    FittedFor wanted{session.opening(),
                     sheet(),
                     session.look.theme,
                     options.load_case,
                     n_drawn_loads(session),
                     options.show,
                     options.circle.has_value(),
                     !options.cuts.empty(),
                     options.is_beside && session.input().is_compared(),
                     session.input().motion != nullptr};
    if (fitted_for_ && fitted_for_->opening == wanted.opening && pressed_) return; // under a hand
    const bool rests = grip_ || workspace.hand.draws() || session.history().is_dragging();
    constexpr int frames_to_settle = 5; // in which the window finds its own layout
    const bool is_settled = fitted_for_ && ImGui::GetFrameCount() - fitted_in_ > frames_to_settle;
    if (is_settled && is_line_of_foot(fitted_for_->sheet, wanted.sheet)) wanted.sheet = fitted_for_->sheet;
    const bool is_another = !fitted_for_ || fitted_for_->opening != wanted.opening;
    const bool has_other_margin = fitted_margin_ && ui::distance(*fitted_margin_, margin_) > 1.0; // another legend
    const bool fits = !has_other_margin && is_all_in_sight(session);
    if (!is_another && fitted_for_ == wanted && (rests || fits)) return;
    fitted_margin_.reset();
    fitted_for_ = wanted;
    fitted_in_ = ImGui::GetFrameCount();
    camera_ = usual_camera(session);
}

bool Canvas::is_all_in_sight(const Session& session) const
{
    const ui::Box room{{0.0, 0.0}, {sheet().width, sheet().height}};
    return std::ranges::all_of(session.model().points, [&](const auto& point) {
        const ui::Point p = camera_.to_sheet({point.at[0], point.at[1]});
        return p.x >= room.min.x && p.x <= room.max.x && p.y >= room.min.y && p.y <= room.max.y;
    });
}

bool Canvas::is_beside_body() const
{
    return room_.width() > 0.0 && (pointer().x > room_.max.x || pointer().y > room_.max.y || pointer().x < room_.min.x);
}

FlatPoint Canvas::place_at(ui::Point on_sheet) const
{
    const ui::World2 place = camera_.to_world(on_sheet);
    return {place.x, place.y};
}

ui::Point Canvas::in_window(const FlatPoint& place) const { return corner() + camera_.to_sheet({place.x, place.y}); }

void Canvas::move_camera(Session& session)
{
    const bool holds_space = ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Space)) && !ImGui::GetIO().WantTextInput;
    const ui::ViewMove hand = view_move({.left = holds_space && !pressed_, .move_at_once = holds_space});
    if (hand.wheel == 0.0 && !hand.is_drag()) return;
    camera_.zoom(pointer(), hand.zoom());
    camera_.pan(hand.drag);
    session.camera = camera_;
}

// ---- the hand

Aim Canvas::aim_at(const Workspace& workspace) const
{
    const Session& session = workspace.session;
    const Hand& hand = workspace.hand;
    const ImGuiIO& io = ImGui::GetIO();
    Aim aim{
        .pointer = place_at(pointer()), .snap = {}, .under = {}, .pixel = 1.0 / camera_.scale(), .adds = io.KeyShift};
    const bool holds_probe = held_reading_ && held_reading_->part.kind == ReadingPart::Kind::Probe;
    const bool probes = held_reading_ ? holds_probe : hand.tool() == ToolKind::Probe;
    SnapOptions options{.reach = snap_reach * aim.pixel,
                        .grid = hand.snaps_to_grid && !probes ? grid_step(camera_) : 0.0,
                        .fine = drawing::round_grid(aim.pixel),
                        .moving = grip_,
                        .to_parts = hand.snaps_to_parts,
                        .is_off = io.KeyAlt || !is_finite(aim.pointer) || hand.picks_in_backdrop()};
    if (hand.curve_tool())
        for (const DraftPlace& place : hand.curve_tool()->places()) options.draft.push_back(place.at);
    aim.snap = snap(session.model(), session.drawing(), aim.pointer, options);
    if (probes && session.look.deformed) { // the body is elsewhere than its drawing
        const Eigen::Vector2d at = place_at_rest(session.input(), session.options(), {aim.pointer.x, aim.pointer.y},
                                                 session.phase());
        aim.snap = {{at.x(), at.y()}, SnapKind::Free};
    }
    if (!hand.curve_tool()) aim.reading = reading_under(session, aim.pointer, pick_reach * aim.pixel);
    if (!hand.draws() && !aim.reading)
        aim.under = part_under(session.model(), session.drawing(), aim.pointer, pick_reach * aim.pixel);
    return aim;
}

void Canvas::follow(Workspace& workspace)
{
    Session& session = workspace.session;
    session.hover.reset();
    if (has_lost_its_hold(session)) let_go();
    if (!is_over() && !is_active() && !pressed_) return;
    move_camera(session);
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Right) && is_over() && !is_moving_view()) end_by_right_click(workspace);
    const Aim aim = aim_at(workspace);
    workspace.hand.point_at(aim);
    if (has_hold_of_view() || is_moving_view()) return;
    if (!grip_ && !is_beside_body()) session.hover = aim.under;
    if (is_pressed() && !is_beside_body()) press(workspace, aim);
    else if (pressed_ && is_active() && is_dragged()) drag(workspace);
    else if (pressed_ && !is_active()) release(workspace, aim);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !aim.under && !workspace.hand.draws()) fit(session);
}

std::optional<ReadingPart> Canvas::reading_under(const Session& session, const FlatPoint& at, double reach) const
{
    Readings drawn = session.look.readings;
    if (session.look.deformed)
        for (FlatPoint& probe : drawn.probes) {
            const Eigen::Vector2d there = drawn_place(session.input(), session.options(), {probe.x, probe.y},
                                                      session.phase());
            probe = {there.x(), there.y()};
        }
    return drawn.at(at, reach);
}

void Canvas::press(Workspace& workspace, const Aim& aim)
{
    pressed_ = aim;
    pressed_in_ = workspace.session.opening();
    Hand& hand = workspace.hand;
    Readings& readings = workspace.session.look.readings;
    if (hand.curve_tool()) return workspace.draw(hand.click(aim));
    if (hand.align_tool()) return workspace.align(hand.align(aim.snap.place));
    const bool holds = aim.reading && !hand.has_begun() && (hand.reads() || hand.tool() == ToolKind::Select);
    if (holds) {
        const Readings before = readings;
        readings.select(*aim.reading);
        held_reading_ = {*aim.reading, before, readings};
        return workspace.session.select_nothing();
    }
    if (hand.reads()) {
        const Readings before = readings;
        read_at(workspace, aim.snap.place);
        if (hand.tool() == ToolKind::Probe) held_reading_ = {*readings.last, before, readings};
        return;
    }
    if (hand.tool() == ToolKind::Erase && aim.reading) return readings.remove(*aim.reading);
    if (hand.tool() == ToolKind::Point) {
        workspace.change({translatable("Place a point"), [place = DraftPlace{aim.snap.place, aim.snap.point}](
                                                             Document& document) { corner_at(document, place); }});
    } else if (hand.tool() == ToolKind::Erase) {
        if (aim.under && !std::holds_alternative<FacePlace>(*aim.under))
            workspace.change({translatable("Erase"),
                              [part = *aim.under](Document& document) { erase_parts(document, std::array{part}); }});
    }
}

/// What the hand took hold of has gone meanwhile, by a key or a command.
bool Canvas::has_lost_its_hold(const Session& session) const
{
    if (!pressed_) return false;
    if (pressed_in_ != session.opening()) return true;
    if (held_reading_ && !(held_reading_->as_left == session.look.readings)) return true;
    const auto& points = session.model().points;
    return grip_ && (grip_->index >= points.size() || points[grip_->index].id != gripped_);
}

void Canvas::let_go()
{
    pressed_.reset();
    held_reading_.reset();
    grip_.reset();
    circle_frame_.reset();
}

void Canvas::drag_reading(Workspace& workspace)
{
    const Session& session = workspace.session;
    workspace.session.look.readings.move(held_reading_->part, aim_at(workspace).snap.place);
    held_reading_->as_left = session.look.readings;
    if (const auto fits = circle_frame(session.input(), session.options()))
        circle_frame_ = circle_frame_ ? mohr::united(*circle_frame_, *fits) : *fits;
}

void Canvas::drag(Workspace& workspace)
{
    if (held_reading_) return drag_reading(workspace);
    if (workspace.hand.tool() != ToolKind::Select) return;
    const auto* const point = pressed_->under ? std::get_if<NodeId>(&*pressed_->under) : nullptr;
    if (!grip_ && point != nullptr) {
        grip_ = *point;
        gripped_ = workspace.session.model()[*point].id;
        workspace.session.select(*point);
    }
    if (!grip_) return;
    const Aim meant = aim_at(workspace); // without the point that is dragged
    workspace.hand.point_at(meant);
    const bool is_to_join = meant.snap.point && meant.snap.point != grip_; // two points at one place until it lets go
    const auto reason = workspace.session.change(
        {{translatable("Move point {id}"), {{"id", workspace.session.model()[*grip_].id}}},
         [grip = *grip_, to = meant.snap.place](Document& document) { move_point(document, grip, to); },
         Step::Drag});
    if (reason && !is_to_join) workspace.session.notify(*reason);
}

void Canvas::release(Workspace& workspace, const Aim& aim)
{
    const Aim pressed = *std::exchange(pressed_, std::nullopt);
    Hand& hand = workspace.hand;
    const bool was_dragged = is_dragged();
    circle_frame_.reset();
    if (std::exchange(held_reading_, std::nullopt)) return;
    if (hand.cut_start() && was_dragged) return read_at(workspace, aim.snap.place);
    if (const auto grip = std::exchange(grip_, std::nullopt)) {
        const auto other = aim.snap.point;
        if (other && other != grip) { // one on the other: they are one from now on
            const std::string joined = workspace.session.model()[*grip].id,
                              stays = workspace.session.model()[*other].id;
            const auto reason = workspace.session.change(
                {{translatable("Join points")},
                 [grip = *grip, by = *other](Document& document) { join_points(document, grip, by); },
                 Step::Drag});
            workspace.session.notify(reason.value_or(ui::Message(translatable("points {gone} and {stays} are one now"),
                                                                 {{"gone", joined}, {"stays", stays}})));
        }
        workspace.session.settle();
        return;
    }
    if (hand.align_tool()) {
        if (was_dragged) workspace.align(hand.align(aim.snap.place));
        return;
    }
    if (hand.has_begun() && was_dragged) { // pressed, dragged, released: from there to here
        workspace.draw(hand.click(aim));
        if (hand.tool() == ToolKind::Line) static_cast<void>(hand.finish());
        return;
    }
    if (hand.tool() == ToolKind::Select && !was_dragged) click_part(workspace, pressed.under, aim.adds);
}

void Canvas::end_by_right_click(Workspace& workspace)
{
    if (!workspace.hand.has_begun()) return;
    if (workspace.hand.align_tool()) return workspace.align(workspace.hand.finish_aligning());
    if (const auto drawn = workspace.hand.finish()) workspace.draw(drawn);
    else workspace.hand.escape();
}

bool Canvas::cancel(Workspace& workspace)
{
    if (held_reading_) {
        workspace.session.look.readings = held_reading_->before;
        let_go();
        return true;
    }
    if (!workspace.session.history().is_dragging()) return false;
    let_go();
    workspace.session.cancel();
    return true;
}

// ---- the picture

ui::Box Canvas::paint_all(const Workspace& workspace, ui::Painter& painter) const
{
    const Session& session = workspace.session;
    const ui::Theme theme(session.look.theme);
    ui::Box room{{0.0, 0.0}, {sheet().width, sheet().height}};
    if (is_empty(session) && !workspace.hand.has_begun()) {
        ui::draw_invitation(painter, theme,
                            {session.tr()("L draws lines, C circles, A arcs, S splines."),
                             session.tr()("A closed outline fills; click it to say what it is made of."),
                             session.tr()("Ctrl+O opens a file, Ctrl+K finds a command.")});
    } else if (!is_empty(session)) {
        room = plane::draw(painter, session.input(), session.options(),
                           {.camera = camera_, .phase = session.phase(), .circle_frame = circle_frame_});
        draw_helpers(painter, session, camera_, room);
        draw_highlight(painter, session, camera_, room);
        draw_problems(painter, workspace, camera_);
    }
    const bool points = is_over() && !is_beside_body();
    if (points || is_active() || grip_) draw_hand(painter, workspace, camera_, room, grip_.has_value());
    else {
        draw_begun(painter, workspace, camera_, room);
        if (!workspace.hand.typed().empty()) draw_typed_at_foot(painter, workspace);
    }
    return room;
}

ui::Picture Canvas::picture_of(const Workspace& workspace) const
{
    const Session& session = workspace.session;
    return painted(
        [&](ui::Painter& painter) { plane::draw(painter, session.input(), session.options(), {.camera = camera_}); });
}

} // namespace plane
