#include "apps/euler/window/player_bar.h"

#include <imgui.h>

#include <array>
#include <string>

#include "ui/widgets/tooltip.h"

namespace euler {

namespace {

/// Triangles and bars on a square sheet of side 1.
struct Icon {
    std::string_view command;
    std::array<double, 2> arrows; ///< left end of each triangle; < 0: none
    std::array<double, 2> bars;   ///< likewise
    bool points_left = false;
};
constexpr double none = -1.0;
constexpr std::array icons{
    Icon{"step.first", {0.30, 0.56}, {0.14, none}, true}, Icon{"step.back", {0.34, none}, {none, none}, true},
    Icon{"step.play", {0.34, none}, {none, none}},        Icon{"step.forward", {0.34, none}, {none, none}},
    Icon{"step.last", {0.14, 0.40}, {0.76, none}},
};
constexpr Icon rest_icon{"step.play", {none, none}, {0.26, 0.60}};

void draw_icon(ui::Painter& painter, const Icon& icon, ui::Color color)
{
    const double side = painter.size().width;
    const double width = 0.32 * side, top = 0.22 * side, bottom = 0.78 * side, middle = 0.5 * side;
    for (const double left : icon.arrows) {
        if (left < 0.0) continue;
        const double a = left * side, b = a + width;
        if (icon.points_left) painter.polygon({{b, top}, {b, bottom}, {a, middle}}, color);
        else painter.polygon({{a, top}, {b, middle}, {a, bottom}}, color);
    }
    for (const double left : icon.bars)
        if (left >= 0.0) painter.rectangle(ui::box_at({left * side, top}, {0.12 * side, bottom - top}), color);
}

void icon_button(Workspace& workspace, const CommandTable& commands, const Icon& icon, ui::ImGuiSession& gui,
                 const ui::Fonts& fonts)
{
    const auto& command = *commands.find(icon.command);
    const auto reason = why_not(command, workspace);
    const float side = ImGui::GetFrameHeight() * 1.25F;
    ImGui::BeginDisabled(reason.has_value());
    const bool is_clicked = ImGui::Button(("###" + std::string(icon.command)).c_str(), {side, side});
    ImGui::EndDisabled();
    const ImVec2 corner = ImGui::GetItemRectMin();
    const double size = static_cast<double>(side) / gui.scale();
    ui::Painter painter({size, size}, fonts);
    const ui::Theme theme(workspace.session.look.theme);
    draw_icon(painter, icon, theme[reason ? ui::Role::FaintLabel : ui::Role::Label].text);
    gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
             {static_cast<double>(corner.x), static_cast<double>(corner.y)});
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        const ui::Catalogue& tr = workspace.session.tr();
        const std::string name = label(command, workspace, tr) + "  (" + text(command.shortcuts.front()) + ")";
        ui::show_tooltip(reason ? tr(*reason) : name);
    }
    if (is_clicked) run(command, workspace);
}

void scrub_bar(Session& session, float width)
{
    int place = static_cast<int>(session.place());
    const auto n = static_cast<int>(session.n_steps());
    const float gap = 0.6F * ImGui::GetFontSize();
    const auto room_beside = [&](const std::string& words) {
        return width - ImGui::CalcTextSize(words.c_str()).x - gap;
    };
    const std::string number = std::to_string(place), count = std::to_string(n);
    std::string words = session.tr()("step {place} of {count}", {{"place", number}, {"count", count}});
    const float least = 5.0F * ImGui::GetFontSize(); // in which a hand finds its place
    if (room_beside(words) < least) words = number + " / " + count;
    if (room_beside(words) < least) words = number;
    ImGui::SetNextItemWidth(std::max(1.0F, room_beside(words)));
    ImGui::BeginDisabled(n == 0);
    if (ImGui::SliderInt("###scrub", &place, 0, n, "", ImGuiSliderFlags_NoInput)) {
        session.is_playing = false;
        session.go_to(static_cast<std::size_t>(place));
    }
    ImGui::EndDisabled();
    ImGui::SameLine(0.0F, gap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(words.c_str());
}

void speed_choice(Session& session)
{
    constexpr std::array speeds{0.25, 0.5, 1.0, 2.0, 4.0};
    constexpr std::array names{"¼×", "½×", "1×", "2×", "4×"};
    std::size_t at = 2;
    for (std::size_t i = 0; i < speeds.size(); ++i)
        if (speeds[i] == session.speed) at = i;
    ImGui::SetNextItemWidth(4.5F * ImGui::GetFontSize());
    if (!ImGui::BeginCombo("###speed", names[at])) {
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", session.tr()("Speed").c_str());
        return;
    }
    for (std::size_t i = 0; i < speeds.size(); ++i)
        if (ImGui::Selectable(names[i], i == at)) session.speed = speeds[i];
    ImGui::EndCombo();
}

} // namespace

void player_bar(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    const float em = ImGui::GetFontSize();
    const float top = ImGui::GetCursorPosY() + 0.125F * ImGui::GetFrameHeight();
    for (const Icon& icon : icons) {
        const bool rests = icon.command == rest_icon.command && workspace.session.is_playing;
        icon_button(workspace, commands, rests ? rest_icon : icon, gui, fonts);
        ImGui::SameLine(0.0F, 0.2F * em);
    }
    ImGui::SetCursorPosY(top);
    scrub_bar(workspace.session, std::max(4.0F * em, ImGui::GetContentRegionAvail().x - 5.0F * em));
    ImGui::SameLine(0.0F, 0.4F * em);
    ImGui::SetCursorPosY(top);
    speed_choice(workspace.session);
}

} // namespace euler
