#pragma once

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ui/command/command_table.h"
#include "ui/text/catalogue.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/tooltip.h"
#include "ui/widgets/wrapped_text.h"

namespace ui {

/// One command as a menu's line; where it cannot run it is grey, and its tip says why.
template <class Session> void show_command(const Command<Session>& command, Session& session, const Catalogue& tr)
{
    const std::optional<Message> reason = why_not(command, session);
    const std::string name = item_label(label(command, session, tr), command.id);
    const std::string keys = command.shortcuts.empty() ? "" : text(command.shortcuts.front());
    const bool is_on = command.is_on && command.is_on(session);
    if (ImGui::MenuItem(name.c_str(), keys.c_str(), is_on, !reason)) run(command, session);
    if (reason && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) show_tooltip(tr(*reason));
}

/// A button for a command, under its label; grey, with the reason under the pointer, where it cannot run.
template <class Workspace>
void command_button(Workspace& workspace, const CommandTable<Workspace>& commands, std::string_view id)
{
    const auto& command = *commands.find(id);
    const Catalogue tr = workspace.tr(); // a command may change the language
    const auto reason = why_not(command, workspace);
    ImGui::BeginDisabled(reason.has_value());
    const bool is_clicked = wrapped_button(label(command, workspace, tr), id);
    ImGui::EndDisabled();
    if (reason && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) show_tooltip(tr(*reason));
    if (is_clicked) run(command, workspace);
}

/// The menus of a table, in the order of their first commands. \pre within a menu bar
template <class Session> void show_menus(const CommandTable<Session>& table, Session& session, const Catalogue& tr)
{
    std::vector<std::string_view> menus;
    for (const auto& command : table.all()) {
        if (!command.menu.empty() && std::ranges::count(menus, command.menu) == 0) menus.push_back(command.menu);
    }
    std::vector<std::string> names;
    for (const std::string_view menu : menus) names.push_back(tr(menu));
    const MenuRow row = menu_row(names);
    const ImVec2 spacing{row.spacing, ImGui::GetStyle().ItemSpacing.y};
    ImGui::SetWindowFontScale(row.type);
    for (std::size_t i = 0; i < menus.size(); ++i) {
        const std::string_view menu = menus[i];
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, spacing);
        keep_next_menu_below();
        const bool is_open = ImGui::BeginMenu((names[i] + "###" + std::string(menu)).c_str());
        ImGui::PopStyleVar();
        if (!is_open) continue;
        ImGui::SetWindowFontScale(1.0F / row.type); // it would have its bar's type
        for (const auto& command : table.all()) {
            if (command.menu == menu) show_command(command, session, tr);
        }
        ImGui::EndMenu();
    }
    ImGui::SetWindowFontScale(1.0F);
}

/// Finds a command by its words: type, choose with the arrows, Enter. One that cannot run now is grey and says why, below
/// the list while it is chosen and under the pointer.
class CommandPalette {
public:
    void open();
    bool is_open() const { return is_open_; }

    template <class Session> void show(const CommandTable<Session>& table, Session& session, const Catalogue& tr)
    {
        if (!is_open_) return;
        const auto found = table.matching(typed_, session, tr);
        const Command<Session>* chosen = nullptr;
        if (begin(tr, found.size())) {
            for (std::size_t i = 0; i < found.size(); ++i) {
                const Reason reason = why_not(*found[i], session);
                const std::string keys = found[i]->shortcuts.empty() ? "" : text(found[i]->shortcuts.front());
                const std::string menu = found[i]->menu.empty() ? "" : tr(found[i]->menu) + "  ›  ";
                const std::string name = menu + label(*found[i], session, tr);
                if (show_line(i, {name, keys, reason ? tr(*reason) : ""})) chosen = found[i];
            }
        }
        end();
        if (chosen != nullptr) {
            is_open_ = false;
            run(*chosen, session);
        }
    }

private:
    struct Line {
        std::string name, keys;
        std::string why_not; ///< empty: it can run now
    };
    bool begin(const Catalogue& tr, std::size_t n_found);
    bool show_line(std::size_t place, const Line& line);
    void end();

    bool is_open_ = false;
    bool is_fresh_ = false;
    bool is_confirmed_ = false;
    std::string typed_;
    std::size_t chosen_ = 0;
    std::string why_not_chosen_; ///< of the chosen line
};

} // namespace ui
