#include "apps/frame/window/view_list.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <utility>

#include "apps/frame/session/view_commands.h"

namespace frame {

using ui::translatable;

bool ViewList::close() { return std::exchange(is_open_, false); }

void ViewList::show(Workspace& workspace)
{
    if (!is_open_) return;
    const ui::Catalogue& tr = workspace.session.view.tr;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::Begin((tr("Kept views") + "###views").c_str(), &is_open_,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    const std::size_t n = workspace.session.document().companion.views.size();
    if (n == 0) ImGui::TextUnformatted(tr("None yet: Ctrl+B keeps how the picture looks now.").c_str());
    names_.resize(n);
    for (std::size_t i = 0; i < workspace.session.document().companion.views.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        show_row(workspace, i);
        ImGui::PopID();
    }
    if (reason_) ImGui::TextUnformatted(tr(*reason_).c_str());
    ImGui::End();
}

void ViewList::show_row(Workspace& workspace, std::size_t place)
{
    Session& session = workspace.session;
    const ui::Catalogue& tr = session.view.tr;
    const std::size_t n = session.document().companion.views.size();
    const bool is_shown = ImGui::Button((tr("Show") + "###show").c_str());
    ImGui::SameLine();
    ImGui::SetNextItemWidth(16.0F * ImGui::GetFontSize());
    const bool is_confirmed = ImGui::InputText("###name", &names_[place], ImGuiInputTextFlags_EnterReturnsTrue);
    const bool is_renamed = is_confirmed || ImGui::IsItemDeactivatedAfterEdit();
    const bool is_typing = ImGui::IsItemActive();
    ImGui::SameLine();
    ImGui::BeginDisabled(place == 0);
    const bool is_raised = ImGui::Button("↑");
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(place + 1 == n);
    const bool is_lowered = ImGui::Button("↓");
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool is_deleted = ImGui::Button((tr("Delete") + "###delete").c_str());
    if (is_renamed) reason_ = rename_view(session, place, names_[place]);
    else if (!is_typing) names_[place] = session.document().companion.views[place].name;
    if (is_shown) show_view(session, place);
    if (is_raised) move_view(session, place, Direction::Earlier);
    if (is_lowered) move_view(session, place, Direction::Later);
    if (is_deleted) erase_view(session, place);
}

} // namespace frame
