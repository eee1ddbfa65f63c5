#include "apps/cross/window/canvas.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "apps/cross/view/hint.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/panels.h"

namespace cross {

namespace {

/// Height of a cell that the last row reads; 0 but on the projector.
double legible_cells(const Session& session)
{
    constexpr double height = 1.2; // of a cell, of its size of type
    return height * legible_type(session.look.full_theme());
}

/// Which sheet of several is seen.
std::size_t stage_of(const Session& session)
{
    return session.worksheet() != nullptr ? session.worksheet_stage() : session.document().stage;
}

ui::Box least_cell(const Drawn& drawn)
{
    const auto height = [](const CellMark& mark) { return mark.box.height(); };
    return std::ranges::min_element(drawn.cells, {}, height)->box;
}

ui::Point middle_of_cell(const Session& session, const Drawn& drawn)
{
    const auto open = std::ranges::find(drawn.cells, session.cell(),
                                        [](const CellMark& mark) { return std::optional(mark.cell); });
    return (open == drawn.cells.end() ? drawn.cells.front() : *open).box.center();
}

} // namespace

void Canvas::show(Session& session, ui::ImGuiSession& gui, bool has_panels)
{
    if (!begin(gui, left_button)) return;
    // The field of a cell or of a value lies on it.
    if (session.worksheet() != nullptr || value_field_.is_open()) ImGui::SetItemAllowOverlap();
    if (session.n_solved() != drawn_of_) {
        drawn_ = {}; // what was drawn is not there any more
        drag_ = {};
    }
    follow(session);
    redraw(session);
    if (enlarge_sheet(session)) redraw(session);
    if (std::exchange(cell_in_sight_, session.cell()) != session.cell() &&
        bring_into_sight(session, drawn_.way_to_cell))
        redraw(session);
    bring_turn_into_sight(session);
    end(gui);
    cell_field_.show(session, drawn_, corner(), static_cast<float>(gui.scale()));
    if (!has_panels && !is_drawn(session, drawn_))
        cell_field_.show_at_foot(session, ui::box_at(corner(), sheet()), static_cast<float>(gui.scale()));
    value_field_.show(session, corner(), static_cast<float>(gui.scale()));
}

void Canvas::redraw(Session& session)
{
    paint([&](ui::Painter& painter) {
        drawn_ = draw(painter, session.scene());
        if (!drawn_.views.empty()) session.look.zoom = drawn_.zoom; // what a hand pulled beyond the end is not kept
        drawn_of_ = session.n_solved();
        draw_hint(painter, session);
    });
}

/// The sheet as large as its columns need, and on the projector the last row, about the cell that is open; once for
/// each sheet, window and theme, so that a hand may see the whole. \returns whether it became larger, or is so no more
bool Canvas::enlarge_sheet(Session& session)
{
    const double least = legible_type(session.look.full_theme());
    const EnlargedFor now{session.n_solved(), stage_of(session), least, sheet().width, sheet().height};
    if (std::exchange(enlarged_for_, now) == now) return false;
    Zoom& zoom = session.look.zoom;
    const bool was_enlarged = zoom.is_of_sheet;
    if (was_enlarged) {
        zoom = {};
        redraw(session);
    }
    if (drawn_.views.empty() || zoom.factor != 1.0 || zoom.middle) return was_enlarged;
    const double larger = times_larger(session);
    if (larger <= 1.0) return was_enlarged;
    const auto closer = drawn_.zoomed_at(zoom, middle_of_interest(session), larger);
    if (!closer) return was_enlarged;
    zoom = *closer;
    zoom.is_of_sheet = true;
    cell_in_sight_.reset(); // it is brought there again
    turn_in_sight_.reset();
    return true;
}

double Canvas::times_larger(const Session& session) const
{
    if (session.worksheet() != nullptr)
        return drawn_.cells.empty() ? 1.0 : legible_cells(session) / least_cell(drawn_).height();
    ui::Painter painter(sheet(), fonts());
    return legible_zoom(painter, session.scene());
}

ui::Point Canvas::middle_of_interest(const Session& session) const
{
    if (session.worksheet() != nullptr) return middle_of_cell(session, drawn_);
    const ui::Box& sheet = drawn_.views.back().box;
    if (!is_beam(drawing::shape_of(session.document().model))) return sheet.center();
    for (const JointMark& mark : drawn_.joints)
        if (mark.part == Part::Sheet) return {sheet.min.x, mark.at.y}; // its columns hang down from it
    return sheet.min;
}

/// \returns whether the pictures moved
bool Canvas::bring_into_sight(Session& session, const std::optional<ui::Point>& way) const
{
    if (!way) return false;
    Zoom& zoom = session.look.zoom;
    const ui::Point from = drawn_.views.back().box.center();
    zoom = drawn_.moved_along(zoom, from, from + *way).value_or(zoom);
    return true;
}

/// An enlarged sheet goes along with the joint that is balanced; where a hand has enlarged all pictures it stays.
void Canvas::bring_turn_into_sight(Session& session)
{
    const std::array turn{session.n_solved(), session.document().stage,
                          session.sheet() != nullptr ? session.sheet()->steps.size() : 0};
    if (std::exchange(turn_in_sight_, turn) == turn || !session.look.zoom.is_of_sheet) return;
    for (int i = 0; i < 2 && bring_into_sight(session, drawn_.way_to_turn); ++i) redraw(session); // first its joint
}

void Canvas::follow(Session& session)
{
    if (session.worksheet() != nullptr) return follow_pupil(session);
    const double scale = ui::Theme(session.look.theme).symbol_scale();
    session.hover = is_over() ? pick(drawn_, pointer(), 26.0 * scale) : std::nullopt; // a lock belongs to its joint
    move_about(session);
    if (!drag_.is_holding() && is_over() && follow_values(session)) return;
    const Aim aim = is_over() ? aim_at(session.document().model, drawn_, pointer(), scale) : Aim{};
    const bool can_pull = !std::holds_alternative<std::monostate>(aim);
    if (session.hover || can_pull || drag_.is_holding()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    const auto* const node = std::get_if<NodeAim>(&aim);
    const bool is_right = is_over() && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    if (node != nullptr && (is_right || (is_pressed() && ImGui::GetIO().KeyShift))) change_support(session, node->node);
    else if (is_pressed() && session.tool != Tool::None) put_load(session, aim);
    else if (is_pressed()) press(session);
    else if (drag_.is_holding() && is_active()) drag_.pull(session, pointer());
    else if (drag_.is_holding()) release(session);
}

/// A double click opens a field and puts no support; nothing else is done where a value is written.
bool Canvas::follow_values(Session& session)
{
    const auto written = written_at(session, drawn_, pointer());
    if (written) session.hover.reset();
    if (written) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    if (!ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return written.has_value();
    session.drop_waiting(); // the first of both clicks may have put a support
    const auto value = value_at(session, drawn_, pointer());
    if (value) value_field_.open(session, *value, pointer());
    const double scale = ui::Theme(session.look.theme).symbol_scale();
    return value || std::holds_alternative<SpanAim>(aim_at(session.document().model, drawn_, pointer(), scale));
}

/// Of a usual size, with a field for another.
void Canvas::put_load(Session& session, const Aim& aim)
{
    const bool is_force = session.tool == Tool::PointLoad;
    const auto* const node = std::get_if<NodeAim>(&aim);
    const auto member = member_at(session.document().model, drawn_, pointer());
    if (!(is_force && node != nullptr) && !member) return;
    const NewLoad added = is_force && node != nullptr ? with_node_load(session, node->node)
                          : is_force                  ? with_point_load(session, member->member, member->x)
                                                      : with_uniform_load(session, member->member);
    session.tool = Tool::None;
    session.change(added.model, is_force ? ui::translatable("Add a force") : ui::translatable("Add a uniform load"));
    value_field_.open(session, added.number, pointer());
}

void Canvas::zoom(Session& session, double factor)
{
    if (drawn_.views.empty()) return;
    const ui::Point at = is_over() ? pointer() : drawn_.views.back().box.center();
    session.look.zoom = drawn_.zoomed_at(session.look.zoom, at, factor).value_or(session.look.zoom);
}

/// The wheel zooms; the middle button, or the left one beside everything, moves the pictures along.
void Canvas::move_about(Session& session)
{
    const bool is_beside = is_active() && !drag_.is_holding() && (has_hold_of_view() || !session.hover);
    const ui::ViewMove hand = view_move({.left = is_beside, .middle = is_over() || has_hold_of_view(), .right = false});
    if (is_over() && hand.wheel != 0.0) zoom(session, hand.zoom(1.2));
    Zoom& zoom = session.look.zoom;
    if (hand.is_drag()) zoom = drawn_.moved_along(zoom, pointer() - hand.drag, pointer()).value_or(zoom);
}

void Canvas::follow_pupil(Session& session)
{
    session.hover.reset();
    if (drag_.is_holding()) drag_.release(session);
    move_about(session);
    const auto cell = is_over() ? pick_cell(drawn_, pointer()) : std::nullopt;
    if (cell) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (is_pressed()) pressed_cell_ = cell;
    if (is_pressed() && cell) {
        session.go_to_cell(cell);
        cell_in_sight_ = cell; // it was seen: nothing moves under the hand
    }
    if (is_released() && !is_moving_view() && !pressed_cell_ && !cell_field_.is_half_typed()) session.go_to_cell({});
    const bool hears_keys = !ImGui::GetIO().WantTextInput && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    const bool is_tab = hears_keys && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab));
    if (is_tab && !session.cell()) session.go_to_cell(session.neighbour(ImGui::GetIO().KeyShift ? -1 : 1, true));
}

void Canvas::press(Session& session)
{
    session.change_at_once();
    if (drag_.press(session, drawn_, pointer(), ui::Theme(session.look.theme).symbol_scale()) || !session.hover) return;
    session.is_playing = false;
    if (const auto reason = session.balance(*session.hover)) session.notify(*reason);
}

void Canvas::release(Session& session)
{
    const auto node = drag_.release(session);
    const auto& task = session.solution().task;
    const auto joint = node && task ? task->problem.joint_at(*node) : std::nullopt;
    if (!joint) return;
    session.is_playing = false;
    if (const auto reason = session.balance(*joint)) session.notify(*reason);
}

bool Canvas::is_over_structure(ui::Point beam) const
{
    constexpr double near = 80.0;
    return is_over() && std::abs(pointer().y - beam.y) < near;
}

void Canvas::draw_hint(ui::Painter& painter, const Session& session) const
{
    if (session.worksheet() != nullptr || !is_over()) return;
    if (drag_.is_holding() || value_field_.is_open() || written_at(session, drawn_, pointer())) return;
    const femoop::Model& model = session.document().model;
    if (session.tool != Tool::None) return draw_load_hint(painter, session);
    const double scale = ui::Theme(session.look.theme).symbol_scale();
    const Aim aim = aim_at(model, drawn_, pointer(), scale);
    for (const Side side : {Side::Left, Side::Right})
        if (const auto sign = sign_beyond(model, drawn_, side, scale); sign && is_over_structure(*sign))
            draw(painter, Hint{.kind = Hint::Kind::Span, .at = *sign, .is_faint = true}, session.look);
    if (const auto* const end = std::get_if<EndAim>(&aim))
        draw(painter, Hint{Hint::Kind::Span, end->at, session.tr()("a span more")}, session.look);
    const auto* const span = std::get_if<SpanAim>(&aim);
    if (span == nullptr) return;
    const ui::DisplayUnits units = units_of(model, session.tr());
    const auto& nodes = model[span->member].nodes;
    const double length = (place_of(model, nodes[1]) - place_of(model, nodes[0])).norm();
    const std::string parts = units.text(span->x, ui::Measure::Length) + " | " +
                              units.text(length - span->x, ui::Measure::Length);
    draw(painter, Hint{Hint::Kind::Support, span->at, parts}, session.look);
}

void Canvas::draw_load_hint(ui::Painter& painter, const Session& session) const
{
    const auto member = member_at(session.document().model, drawn_, pointer());
    if (!member) return;
    const ui::DisplayUnits units = units_of(session.document().model, session.tr());
    const std::string words = session.tool == Tool::PointLoad ? units.text(member->x, ui::Measure::Length)
                                                              : session.tr()("a uniform load");
    draw(painter, Hint{Hint::Kind::Load, member->at, words}, session.look);
}

ui::Picture Canvas::picture_of(const Session& session) const
{
    Scene scene = session.scene();
    scene.hover.reset();
    scene.cell.reset();
    return painted([&](ui::Painter& painter) { draw(painter, scene); });
}

std::optional<ui::Point> Canvas::in_window(femoop::cross::JointId joint, Part part) const
{
    for (const JointMark& mark : drawn_.joints)
        if (mark.joint == joint && mark.part == part) return corner() + mark.at;
    return std::nullopt;
}

} // namespace cross
