// The tabs of the panel: a table each, or several in a list, and the diagrams of the member.
#include <imgui.h>

#include <algorithm>

#include "apps/frame/session/table_commands.h"
#include "apps/frame/window/tables_panel.h"
#include "ui/text/catalogue.h"

namespace frame {

using ui::translatable;

// One tab beside the other, in a second row where there is no room.
bool TablesPanel::begin_tab(const std::string& label, bool is_chosen)
{
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float gap = 0.3F * ImGui::GetFontSize();
    const float width = ImGui::CalcTextSize(label.c_str(), nullptr, true).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    const bool is_first = ImGui::GetCursorPosX() <= ImGui::GetWindowContentRegionMin().x + 1.0F &&
                          ImGui::GetCursorPosY() <= ImGui::GetWindowContentRegionMin().y + 1.0F;
    if (!is_first && ImGui::GetItemRectMax().x + gap + width <= end) ImGui::SameLine(0.0F, gap);
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(is_chosen ? ImGuiCol_TabActive : ImGuiCol_Tab));
    const bool is_clicked = ImGui::Button(label.c_str());
    ImGui::PopStyleColor();
    return is_clicked;
}

bool TablesPanel::tab(Workspace& workspace, TableKind kind)
{
    const bool is_chosen = workspace.bottom.table == kind && workspace.bottom.shows(BottomContent::Table);
    const std::string label = workspace.session.view.tr(title(kind)) + "###" + std::string(command_id(kind));
    if (!begin_tab(label, is_chosen)) return false;
    workspace.bottom = {true, kind};
    has_keyboard_ = true;
    return true;
}

// Several tables in one tab: which one is chosen from a list.
void TablesPanel::show_group(Workspace& workspace, std::string_view label, std::initializer_list<TableKind> kinds)
{
    const ui::Catalogue& tr = workspace.session.view.tr;
    const bool is_chosen = std::ranges::find(kinds, workspace.bottom.table) != kinds.end() &&
                           workspace.bottom.shows(BottomContent::Table);
    const std::string name = tr(is_chosen ? title(workspace.bottom.table) : label);
    const std::string list = "###tables of " + std::string(label);
    if (begin_tab(name + " …###" + std::string(label), is_chosen)) ImGui::OpenPopup(list.c_str());
    if (!ImGui::BeginPopup(list.c_str())) return;
    for (const TableKind kind : kinds) {
        const std::size_t n = is_result(kind) ? 0 : parts_of(workspace.session.model(), kind).size();
        const std::string entry = tr(title(kind)) + (n > 0 ? " (" + std::to_string(n) + ")" : "");
        if (!ImGui::MenuItem(entry.c_str(), nullptr, workspace.bottom.table == kind)) continue;
        workspace.bottom = {true, kind};
        has_keyboard_ = true;
    }
    ImGui::EndPopup();
}

void TablesPanel::show_tabs(Workspace& workspace)
{
    using enum TableKind;
    tab(workspace, Nodes);
    show_group(workspace, translatable("Members"), {Members, Joints});
    tab(workspace, Materials);
    tab(workspace, Sections);
    show_group(workspace, translatable("Loads"),
               {LoadCases, Combinations, NodeLoads, DistributedLoads, PointLoads, EndLoads, Misfits, Temperatures,
                Settlements});
    for (const TableKind kind : {Displacements, Reactions, MemberEnds, Extremes}) tab(workspace, kind);
    show_group(workspace, translatable("Envelope"), {Envelope, ReactionEnvelope});
    show_member_tab(workspace);
    const ui::Catalogue& tr = workspace.session.view.tr;
    if (workspace.bottom.shows(BottomContent::Table) && begin_tab(tr("CSV…") + "###csv", false))
        ask_for_file(workspace);
    if (workspace.bottom.shows(BottomContent::Table) && ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", tr("Export the table as CSV…").c_str());
}

// It names the member whose diagrams it shows.
void TablesPanel::show_member_tab(Workspace& workspace)
{
    const Session& session = workspace.session;
    const std::optional<femoop::MemberId> member = MemberPanel::member_of(session);
    const std::string name = session.view.tr(member ? title(session.model(), *member)
                                                    : ui::Message(translatable("Diagrams of the member")));
    if (!begin_tab(name + "###member", workspace.bottom.shows(BottomContent::Member))) return;
    workspace.bottom.content = BottomContent::Member;
    has_keyboard_ = true;
}

} // namespace frame
