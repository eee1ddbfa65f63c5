#include "ui/widgets/player_bar.h"

#include <algorithm>
#include <array>

namespace ui {

namespace {

/// Triangles and bars on a square sheet of side 1.
struct PlayerIcon {
    std::array<double, 2> arrows; ///< left end of each triangle; < 0: none
    std::array<double, 2> bars;   ///< likewise
    bool points_left = false;
};
constexpr double no_part = -1.0;
constexpr std::array player_icons{
    PlayerIcon{{0.30, 0.56}, {0.14, no_part}, true}, PlayerIcon{{0.34, no_part}, {no_part, no_part}, true},
    PlayerIcon{{0.34, no_part}, {no_part, no_part}}, PlayerIcon{{no_part, no_part}, {0.26, 0.60}},
    PlayerIcon{{0.34, no_part}, {no_part, no_part}}, PlayerIcon{{0.14, 0.40}, {0.76, no_part}},
};

void draw_player_icon(Painter& painter, const PlayerIcon& icon, Color color)
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
        if (left >= 0.0) painter.rectangle(box_at({left * side, top}, {0.12 * side, bottom - top}), color);
}

std::optional<std::size_t> scrub_bar(const PlayerSteps& steps, float width, const Catalogue& tr)
{
    int place = static_cast<int>(steps.place);
    const auto n = static_cast<int>(steps.n);
    const float gap = 0.6F * ImGui::GetFontSize();
    const auto room_beside = [&](const std::string& words) {
        return width - ImGui::CalcTextSize(words.c_str()).x - gap;
    };
    const std::string number = std::to_string(place), count = std::to_string(n);
    std::string words = tr("step {place} of {count}", {{"place", number}, {"count", count}});
    const float least = 5.0F * ImGui::GetFontSize(); // in which a hand finds its place
    if (room_beside(words) < least) words = number + " / " + count;
    if (room_beside(words) < least) words = number;
    ImGui::SetNextItemWidth(std::max(1.0F, room_beside(words)));
    ImGui::BeginDisabled(n == 0);
    const bool is_moved = ImGui::SliderInt("###scrub", &place, 0, n, "", ImGuiSliderFlags_NoInput);
    ImGui::EndDisabled();
    ImGui::SameLine(0.0F, gap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(words.c_str());
    return is_moved ? std::optional(static_cast<std::size_t>(place)) : std::nullopt;
}

std::optional<double> speed_choice(double speed, const Catalogue& tr)
{
    constexpr std::array speeds{0.25, 0.5, 1.0, 2.0, 4.0};
    constexpr std::array names{"¼×", "½×", "1×", "2×", "4×"};
    std::optional<double> chosen;
    std::size_t at = 2;
    for (std::size_t i = 0; i < speeds.size(); ++i)
        if (speeds[i] == speed) at = i;
    ImGui::SetNextItemWidth(4.5F * ImGui::GetFontSize());
    if (!ImGui::BeginCombo("###speed", names[at])) {
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tr("Speed").c_str());
        return chosen;
    }
    for (std::size_t i = 0; i < speeds.size(); ++i)
        if (ImGui::Selectable(names[i], i == at)) chosen = speeds[i];
    ImGui::EndCombo();
    return chosen;
}

} // namespace

bool player_button(std::string_view id, PlayerButton button, bool is_enabled, const Theme& theme, ImGuiSession& gui,
                   const Fonts& fonts)
{
    const float side = ImGui::GetFrameHeight() * 1.25F;
    ImGui::BeginDisabled(!is_enabled);
    const bool is_clicked = ImGui::Button(("###" + std::string(id)).c_str(), {side, side});
    ImGui::EndDisabled();
    const ImVec2 corner = ImGui::GetItemRectMin();
    const double size = static_cast<double>(side) / gui.scale();
    Painter painter({size, size}, fonts);
    const Role role = is_enabled ? Role::Label : Role::FaintLabel;
    draw_player_icon(painter, player_icons[static_cast<std::size_t>(button)], theme[role].text);
    gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
             {static_cast<double>(corner.x), static_cast<double>(corner.y)});
    return is_clicked;
}

PlayerChange player_slider(const PlayerSteps& steps, float top, const Catalogue& tr)
{
    const float em = ImGui::GetFontSize();
    PlayerChange change;
    ImGui::SetCursorPosY(top);
    change.place = scrub_bar(steps, std::max(4.0F * em, ImGui::GetContentRegionAvail().x - 5.0F * em), tr);
    ImGui::SameLine(0.0F, 0.4F * em);
    ImGui::SetCursorPosY(top);
    change.speed = speed_choice(steps.speed, tr);
    return change;
}

} // namespace ui
