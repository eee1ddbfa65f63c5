#include "apps/frame/window/reading_windows.h"

#include <imgui.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "apps/frame/window/no_results.h"

namespace frame {

void description_window(Desk& desk, bool& is_open)
{
    if (!is_open) return;
    const ui::Catalogue& tr = desk.session.view.tr;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({46.0F * em, 32.0F * em}, ImGuiCond_Appearing);
    ImGui::Begin((tr("Model and results in words") + "###description").c_str(), &is_open,
                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    const std::string words = desk.session.in_words();
    if (ImGui::Button((tr("Copy") + "###copy").c_str())) ImGui::SetClipboardText(words.c_str());
    if (desk.session.hidden) ImGui::SameLine();
    offer_to_reveal(desk);
    ImGui::BeginChild("words");
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndChild();
    ImGui::End();
}

namespace {

/// A line of the sheet of keys: a command, or with no key the menu that the next ones stand in.
struct KeyLine {
    std::string key, words;
};

// Menus in the order of their first command; what stands in none comes first.
std::vector<KeyLine> key_lines(const Desk& desk, const CommandTable& commands)
{
    const ui::Catalogue& tr = desk.session.view.tr;
    std::vector<std::string_view> menus;
    for (const auto& command : commands.all())
        if (std::ranges::find(menus, command.menu) == menus.end()) menus.push_back(command.menu);
    std::vector<KeyLine> lines;
    for (const std::string_view menu : menus) {
        const std::size_t begin = lines.size();
        for (const auto& command : commands.all())
            if (command.menu == menu && !command.shortcuts.empty())
                lines.push_back({text(command.shortcuts.front()), ui::label(command, desk, tr)});
        const auto at = lines.begin() + static_cast<std::ptrdiff_t>(begin);
        if (lines.size() > begin && !menu.empty()) lines.insert(at, {"", tr(menu)});
    }
    return lines;
}

// As many lines as have room below one another; a menu's title stays with its first command.
std::span<const KeyLine> next_column(std::span<const KeyLine> lines, std::size_t n_most)
{
    if (lines.size() <= n_most) return lines;
    const bool ends_with_title = n_most > 1 && lines[n_most - 1].key.empty();
    return lines.first(ends_with_title ? n_most - 1 : n_most);
}

void key_column(std::span<const KeyLine> lines, const char* id)
{
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit |
                                      ImGuiTableFlags_NoHostExtendX;
    if (!ImGui::BeginTable(id, 2, flags)) return;
    for (const KeyLine& line : lines) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(line.key.c_str());
        ImGui::TableNextColumn();
        if (line.key.empty()) ImGui::TextDisabled("%s", line.words.c_str());
        else ImGui::TextUnformatted(line.words.c_str());
    }
    ImGui::EndTable();
}

} // namespace

void shortcut_window(const Desk& desk, const CommandTable& commands, bool& is_open)
{
    if (!is_open) return;
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport.GetCenter(), ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::Begin((desk.session.view.tr("Keys") + "###shortcuts").c_str(), &is_open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    const float row = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    const auto n_most = static_cast<std::size_t>(std::max(1.0F, 0.8F * viewport.WorkSize.y / row));
    const std::vector<KeyLine> lines = key_lines(desk, commands);
    const std::size_t n_columns = lines.size() / n_most + 1;
    const std::size_t n_rows = lines.size() / n_columns + 1; // columns of like length
    std::size_t n_shown = 0;
    while (n_shown < lines.size()) {
        if (n_shown > 0) ImGui::SameLine(0.0F, 2.0F * ImGui::GetFontSize());
        const auto column = next_column(std::span(lines).subspan(n_shown), n_rows);
        key_column(column, ("keys" + std::to_string(n_shown)).c_str());
        n_shown += column.size();
    }
    ImGui::End();
}

} // namespace frame
