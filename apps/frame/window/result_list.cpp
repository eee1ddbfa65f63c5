#include "apps/frame/window/result_list.h"
#include "ui/widgets/item_label.h"

#include <imgui.h>

#include <algorithm>

namespace frame {

namespace {

// A column is as broad as what stands in it from its left edge: text that was moved to the right would keep it as broad
// as it is.
void right_aligned(const std::string& text)
{
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = std::max(0.0F, ImGui::GetContentRegionAvail().x - size.x);
    ImGui::GetWindowDrawList()->AddText({at.x + room, at.y}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    ImGui::Dummy(size);
}

} // namespace

void result_list(const char* id, const std::vector<std::string>& headings, std::size_t n_rows,
                 const std::function<void(std::size_t)>& row)
{
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_ScrollX |
                                      ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit;
    const float line = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    float& bar = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID(id)); // where the table was too wide
    const float height = std::min(static_cast<float>(n_rows + 1) * line, 12.0F * line) + bar + 2.0F;
    if (!ImGui::BeginTable(id, static_cast<int>(headings.size()), flags, {0.0F, height})) return;
    ImGui::TableSetupScrollFreeze(1, 1);
    for (const std::string& heading : headings) ImGui::TableSetupColumn(heading.c_str());
    ImGui::TableHeadersRow();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(n_rows));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::PushID(i);
            row(static_cast<std::size_t>(i));
            ImGui::PopID();
        }
    }
    bar = ImGui::GetScrollMaxX() > 0.0F ? ImGui::GetStyle().ScrollbarSize : 0.0F;
    ImGui::EndTable();
}

void part_cell(Session& session, const Part& part, const std::string& name)
{
    const bool is_selected = session.selection.contains(part);
    if (ImGui::Selectable(ui::shown_whole(name).c_str(), is_selected, ImGuiSelectableFlags_SpanAllColumns))
        session.selection = part;
}

void number_cell(const std::string& text)
{
    ImGui::TableNextColumn();
    right_aligned(text);
}

void number_cell(Workspace& workspace, const std::string& text, const PointedNumber& number,
                 const std::optional<Part>& part)
{
    ImGui::TableNextColumn();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 end{corner.x + ImGui::GetContentRegionAvail().x, corner.y + ImGui::GetTextLineHeight()};
    right_aligned(text);
    if (!ImGui::IsWindowHovered() || !ImGui::IsMouseHoveringRect(corner, end)) return;
    workspace.pointed_number = number;
    if (!ImGui::IsMouseReleased(ImGuiMouseButton_Right)) return;
    if (part) workspace.session.selection = *part;
    workspace.menu_number = number;
    workspace.requests.push_back(Request::ContextMenu);
}

void name_cell(const std::string& text)
{
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

bool result_section(const std::string& title, const char* id)
{
    return ImGui::CollapsingHeader((title + "###" + id).c_str(), ImGuiTreeNodeFlags_DefaultOpen);
}

} // namespace frame
