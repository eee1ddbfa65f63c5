#include "apps/frame/window/canvas.h"

#include <imgui.h>

#include <cmath>
#include <utility>
#include <variant>

#include "apps/frame/session/snapping.h"
#include "apps/frame/view/reading.h"

namespace frame {

namespace {

constexpr double zoom_per_turn = 1.15;

std::optional<std::size_t> shown_mechanism(const Session& session)
{
    return session.solution().mechanisms.empty() ? std::nullopt : std::optional(session.mechanism);
}

Subject subject(const Session& session, const ViewOptions& options)
{
    const Solution& solution = session.solution();
    if (const auto i = shown_mechanism(session))
        return {session.model(), MotionChoice{solution.mechanisms, *i}, options};
    return {session.model(), solution.results ? &*solution.results : nullptr, options};
}

ui::World3 middle_of(const StructureShape& shape)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& node : shape.nodes) sum += node;
    if (!shape.nodes.empty()) sum /= static_cast<double>(shape.nodes.size());
    return {sum.x(), sum.y(), sum.z()};
}

} // namespace

void Canvas::fit(Session& session)
{
    session.view.camera.reset();
    fitted_for_.reset();
}

void Canvas::follow_structure(const Session& session)
{
    if (generation_ != session.generation()) shape_ = shape_of(session.model());
    generation_ = session.generation();
    ViewOptions options = session.view;
    options.phase = 1.0; // room for the whole motion
    const FittedFor wanted{sheet_,
                           options.show,
                           options.layout,
                           options.theme,
                           shape_.nodes,
                           session.model().analysis,
                           shown_mechanism(session)};
    const bool is_fitted = fitted_for_ == wanted;
    if (!options.camera && is_fitted) options.camera = plan_.camera;
    if (!session.view.camera) fitted_for_ = wanted;
    plan_ = subject(session, options).plan(sheet_, fonts_);
}

ui::Point Canvas::corner_of_panel(ui::Point at) const
{
    for (const Panel& panel : plan_.panels) {
        if (panel.box.contains(at)) return panel.box.min;
    }
    return plan_.panels.empty() ? ui::Point{} : plan_.panels.front().box.min;
}

Projection Canvas::projection_at(ui::Point at) const { return Projection(plan_.camera, corner_of_panel(at)); }

void Canvas::zoom(Session& session, double factor) const
{
    if (plan_.panels.empty()) return;
    const ui::Size size = plan_.panels.front().box.size();
    Camera changed = plan_.camera;
    std::visit([&](auto& camera) { camera.zoom({0.5 * size.width, 0.5 * size.height}, factor); }, changed);
    session.view.camera = changed;
}

// Logical pixels of a unit of length along the member, as it is seen.
double Canvas::pixels_along(const Projection& projection, const Cut& cut) const
{
    const MemberShape& member = shape_[cut.member];
    const double seen = distance(projection(member.start), projection(member.end));
    return member.length > 0.0 ? seen / member.length : 0.0;
}

std::optional<ui::Point> Canvas::in_window(const Eigen::Vector3d& place) const
{
    if (plan_.panels.empty()) return std::nullopt;
    return corner_ + projection_at(plan_.panels.front().box.min)(place);
}

std::optional<ui::Point> Canvas::in_window(const Cut& cut) const
{
    if (cut.member.index >= shape_.members.size()) return std::nullopt;
    return in_window(shape_[cut.member].at(cut.x));
}

void Canvas::show(Desk& desk, ui::ImGuiSession& gui)
{
    Session& session = desk.session;
    const auto scale = static_cast<float>(gui.scale());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (room.x < 8.0F || room.y < 8.0F) return;
    corner_ = {static_cast<double>(corner.x / scale), static_cast<double>(corner.y / scale)};
    sheet_ = {static_cast<double>(room.x / scale), static_cast<double>(room.y / scale)};
    follow_structure(session);

    ImGui::InvisibleButton("canvas", room,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                               ImGuiButtonFlags_MouseButtonRight);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const ui::Point at{static_cast<double>((mouse.x - corner.x) / scale),
                       static_cast<double>((mouse.y - corner.y) / scale)};
    follow(desk, {at, ImGui::IsItemHovered() || ImGui::IsItemActive()});
    paint(session);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(corner, {corner.x + room.x, corner.y + room.y}, true);
    gui.show(*picture_, list, {static_cast<double>(corner.x), static_cast<double>(corner.y)});
    list.PopClipRect();
}

void Canvas::follow(Desk& desk, const Pointer& pointer)
{
    Session& session = desk.session;
    session.hover.reset();
    session.view.hover = {};
    if (!pointer.is_over) return;
    const Projection projection = projection_at(pointer.at);
    Pick under = pick(shape_, projection, pointer.at, session.solution().results ? session.view.show : ShowSet{});
    if (under.cut) under.cut = snapped(session, shape_, *under.cut, pixels_along(projection, *under.cut));
    const double wheel = static_cast<double>(ImGui::GetIO().MouseWheel);
    if (wheel != 0.0) {
        Camera changed = plan_.camera;
        const ui::Point cursor = pointer.at - corner_of_panel(pointer.at);
        std::visit([&](auto& camera) { camera.zoom(cursor, std::pow(zoom_per_turn, wheel)); }, changed);
        session.view.camera = changed;
    }
    move(session);
    if (is_panning_) return;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && under.is_nothing()) fit(session);
    if (under.node) session.view.hover.nodes.push_back(*under.node);
    if (under.cut) session.view.hover.members.push_back(under.cut->member);
    session.hover = under.cut;
    hover_panel_ = corner_of_panel(pointer.at);
    if (ImGui::IsMouseReleased(ImGuiMouseButton_Left)) press(session, under);
}

// A click, told apart from the end of a drag by the caller.
void Canvas::press(Session& session, const Pick& under)
{
    if (under.node) session.selection = *under.node;
    if (under.cut) session.selection = under.cut->member;
    if (under.is_nothing()) session.selection.reset();
    session.pin = under.cut;
}

void Canvas::move(Session& session)
{
    const ImGuiIO& io = ImGui::GetIO();
    const bool is_held = ImGui::IsMouseDown(ImGuiMouseButton_Left) || ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                         ImGui::IsMouseDown(ImGuiMouseButton_Right);
    if (!is_held) {
        // The release of a drag is no click; it is seen in the frame in which nothing is held any more.
        if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left)) is_panning_ = false;
        return;
    }
    const bool is_left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    const bool has_moved = ImGui::IsMouseDragging(ImGuiMouseButton_Left) ||
                           ImGui::IsMouseDragging(ImGuiMouseButton_Middle) ||
                           ImGui::IsMouseDragging(ImGuiMouseButton_Right);
    if (!is_panning_ && !has_moved) return;
    is_panning_ = true;
    const double pixel = sheet_.width / std::max(1.0, static_cast<double>(ImGui::GetItemRectSize().x));
    const ui::Point drag{pixel * static_cast<double>(io.MouseDelta.x), pixel * static_cast<double>(io.MouseDelta.y)};
    Camera changed = plan_.camera;
    auto* const orbit = std::get_if<ui::OrbitCamera>(&changed);
    if (orbit != nullptr && is_left && !io.KeyShift) {
        orbit->orbit(drag, middle_of(shape_));
    } else {
        std::visit([&](auto& camera) { camera.pan(drag); }, changed);
    }
    session.view.camera = changed;
}

void Canvas::paint(const Session& session)
{
    ViewOptions options = session.view;
    options.camera = session.view.camera.value_or(plan_.camera);
    if (session.selection) {
        if (const auto* const node = std::get_if<femoop::NodeId>(&*session.selection))
            options.selection.nodes.push_back(*node);
        if (const auto* const member = std::get_if<femoop::MemberId>(&*session.selection))
            options.selection.members.push_back(*member);
    }
    ui::Painter painter(sheet_, fonts_);
    subject(session, options).draw(painter);
    if (const auto& results = session.solution().results) {
        const auto read = [&](const Cut& cut, ui::Point panel) {
            const ui::Point at = Projection(*options.camera, panel)(shape_[cut.member].at(cut.x));
            draw_reading(painter, session.model(), *results, options, cut, at);
        };
        if (session.pin && !plan_.panels.empty()) read(*session.pin, plan_.panels.front().box.min);
        if (session.hover && session.hover != session.pin) read(*session.hover, hover_panel_);
    }
    picture_ = painter.picture();
}

} // namespace frame
