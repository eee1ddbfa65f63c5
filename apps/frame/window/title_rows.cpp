#include "apps/frame/window/title_rows.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <utility>

#include "apps/frame/session/new_commands.h"
#include "apps/frame/session/property_commands.h"

namespace frame {

using ui::translatable;

void TitleRows::show(Workspace& workspace)
{
    const ui::Catalogue& tr = workspace.session.view.tr;
    ImGui::TextUnformatted(tr(label_of(workspace.session.model().analysis)).c_str());
    ImGui::Separator();
    show_title(workspace);
    show_notes(workspace);
    ImGui::Spacing();
}

void TitleRows::show_title(Workspace& workspace)
{
    const std::string words = workspace.session.view.tr(translatable("Title"));
    ImGui::SetNextItemWidth(-1.0F);
    if (std::exchange(begins_, false)) ImGui::SetKeyboardFocusHere();
    const auto flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
    const bool is_confirmed = ImGui::InputTextWithHint("###title", words.c_str(), &title_, flags);
    if (is_confirmed || ImGui::IsItemDeactivatedAfterEdit()) set_title(workspace.session, title_);
    if (!ImGui::IsItemActive()) title_ = workspace.session.model().title;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", words.c_str());
}

void TitleRows::show_notes(Workspace& workspace)
{
    const std::string words = workspace.session.view.tr(translatable("Notes"));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    std::string notes = workspace.session.model().notes;
    if (notes_.show("###notes", notes)) set_notes(workspace.session, notes);
    if (ImGui::IsItemActive() || !notes.empty()) return;
    const ImVec2 at{corner.x + ImGui::GetStyle().FramePadding.x, corner.y + ImGui::GetStyle().FramePadding.y};
    ImGui::GetWindowDrawList()->AddText(at, ImGui::GetColorU32(ImGuiCol_TextDisabled), words.c_str());
}

} // namespace frame
