#pragma once

#include <imgui.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ui/command/command_table.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/widgets/tooltip.h"

namespace ui {

/// What a button of a player is for.
enum class PlayerButton : std::uint8_t { First, Back, Play, Rest, Forward, Last };

/// Where a player is among its steps, and how fast it goes.
struct PlayerSteps {
    std::size_t place = 0, n = 0;
    double speed = 1.0;
};
/// What a hand did on the bar.
struct PlayerChange {
    std::optional<std::size_t> place{}; ///< that it moved the step to
    std::optional<double> speed{};
};

/// The names of a player's commands.
struct PlayerCommands {
    std::string_view first, back, play, forward, last;
};

/// A square button with its sign, greyed where it is not enabled. True when it is clicked.
bool player_button(std::string_view id, PlayerButton button, bool is_enabled, const Theme& theme, ImGuiSession& gui,
                   const Fonts& fonts);
/// The bar that is scrubbed and the speed, in the room that is left of the row.
/// \param top  of what has the height of a line
PlayerChange player_slider(const PlayerSteps& steps, float top, const Catalogue& tr);

/// The buttons that walk through steps, the bar that is scrubbed, and the speed.
template <class Workspace>
PlayerChange player_bar(Workspace& workspace, const CommandTable<Workspace>& commands, const PlayerCommands& names,
                        bool is_playing, const PlayerSteps& steps, const Theme& theme, ImGuiSession& gui,
                        const Fonts& fonts)
{
    const auto& tr = workspace.session.tr();
    const float top = ImGui::GetCursorPosY() + 0.125F * ImGui::GetFrameHeight();
    const auto show = [&](std::string_view id, PlayerButton button) {
        const auto& command = *commands.find(id);
        const auto reason = why_not(command, workspace);
        const bool is_clicked = player_button(id, button, !reason, theme, gui, fonts);
        if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
            const std::string name = label(command, workspace, tr) + "  (" + text(command.shortcuts.front()) + ")";
            show_tooltip(reason ? tr(*reason) : name);
        }
        if (is_clicked) run(command, workspace);
        ImGui::SameLine(0.0F, 0.2F * ImGui::GetFontSize());
    };
    show(names.first, PlayerButton::First);
    show(names.back, PlayerButton::Back);
    show(names.play, is_playing ? PlayerButton::Rest : PlayerButton::Play);
    show(names.forward, PlayerButton::Forward);
    show(names.last, PlayerButton::Last);
    return player_slider(steps, top, tr);
}

} // namespace ui
