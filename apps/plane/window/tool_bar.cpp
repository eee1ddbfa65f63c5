#include "apps/plane/window/tool_bar.h"

#include <imgui.h>

#include <string>

#include "apps/plane/window/tool_icon.h"
#include "ui/widgets/command_combo.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/tooltip.h"
#include "ui/widgets/wrapped_text.h"

namespace plane {

namespace {

// One button of the row: the tool's icon, framed where the hand holds it.
void tool_button(Workspace& workspace, const CommandTable& commands, const ToolEntry& entry, ui::ImGuiSession& gui,
                 const ui::Fonts& fonts)
{
    const auto& command = *commands.find(entry.id);
    const ui::Catalogue& tr = workspace.session.tr();
    const float side = ImGui::GetFrameHeight() * 1.25F;
    const bool is_on = command.is_on(workspace);
    if (is_on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
    const bool is_clicked = ImGui::Button(("###" + std::string(entry.id)).c_str(), {side, side});
    if (is_on) ImGui::PopStyleColor();
    const ImVec2 corner = ImGui::GetItemRectMin();
    const double edge = 0.12 * static_cast<double>(side);
    const double size = (static_cast<double>(side) - 2.0 * edge) / gui.scale();
    ui::Painter painter({size, size}, fonts);
    draw_tool_icon(painter, entry.value, ui::Theme(workspace.session.look.theme));
    gui.show(painter.picture(), *ImGui::GetWindowDrawList(),
             {static_cast<double>(corner.x) + edge, static_cast<double>(corner.y) + edge});
    if (ImGui::IsItemHovered()) ui::show_tooltip(tr(entry.label) + "  (" + text(command.shortcuts.front()) + ")");
    if (is_clicked) run(command, workspace);
}

void switch_box(Workspace& workspace, const CommandTable& commands, std::string_view id)
{
    const auto& command = *commands.find(id);
    bool is_on = command.is_on(workspace);
    const std::string label = ui::label_beside_box(workspace.tr()(command.label), id);
    if (ImGui::Checkbox(label.c_str(), &is_on)) run(command, workspace);
}

} // namespace

void tool_bar(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui, const ui::Fonts& fonts)
{
    for (const ToolEntry& entry : tools()) {
        tool_button(workspace, commands, entry, gui, fonts);
        ImGui::SameLine();
    }
}

void show_panel(Workspace& workspace, const CommandTable& commands)
{
    ImGui::TextUnformatted(workspace.tr()("Show").c_str());
    ImGui::Separator();
    for (const char* id : {"view.show.regions", "view.show.supports", "view.show.loads", "view.show.values",
                           "view.show.names", "view.show.legend"})
        switch_box(workspace, commands, id);
    ImGui::Spacing();
    ImGui::TextUnformatted(workspace.tr()("Results").c_str());
    ImGui::Separator();
    for (const char* id : {"results.mesh", "results.deformed", "results.principal", "results.trajectories",
                           "results.error", "results.reactions", "results.circle"})
        switch_box(workspace, commands, id);
    switch_box(workspace, commands, "results.animate");
    const auto field = workspace.session.look.field;
    ui::command_combo(workspace, commands, "###field", fields(),
                      [&](const FieldEntry& entry) { return entry.value == field; });
    ImGui::Spacing();
    ImGui::TextUnformatted(workspace.tr()("Draw").c_str());
    ImGui::Separator();
    for (const char* id : {"draw.grid", "draw.parts"}) switch_box(workspace, commands, id);
}

} // namespace plane
