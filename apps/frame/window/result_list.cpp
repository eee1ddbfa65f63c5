#include "apps/frame/window/result_list.h"
#include "ui/widgets/item_label.h"

#include <imgui.h>

#include <algorithm>
#include <numeric>

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

/// How broad the columns of a table have to be, by what stands in sight.
class ResultColumns {
public:
    using FillRow = std::function<void(ResultRow&, std::size_t)>;
    ResultColumns(const std::vector<std::string>& headings, const FillRow& row) : row_(row)
    {
        for (const std::string& heading : headings)
            widths_.push_back(ImGui::CalcTextSize(heading.c_str(), nullptr, true).x);
    }

    void measure(std::size_t i)
    {
        ResultRow cells(&widths_);
        row_(cells, i);
    }
    void draw(std::size_t i) const
    {
        ResultRow cells(nullptr);
        row_(cells, i);
    }
    float width(std::size_t column) const { return widths_[column]; }
    float all() const
    {
        const float gaps = 2.0F * ImGui::GetStyle().CellPadding.x * static_cast<float>(widths_.size() - 1);
        return std::accumulate(widths_.begin(), widths_.end(), gaps);
    }

private:
    const FillRow& row_;
    std::vector<float> widths_;
};

bool ResultRow::begin_cell(const std::string& text)
{
    if (widths_ == nullptr) {
        ImGui::TableNextColumn();
        return true;
    }
    float& width = (*widths_)[column_++];
    width = std::max(width, ImGui::CalcTextSize(text.c_str()).x);
    return false;
}

void ResultRow::part(Session& session, const Part& part, const std::string& name)
{
    const std::string shown = ui::shown_whole(name);
    if (!begin_cell(shown)) return;
    const bool is_selected = session.selection.contains(part);
    if (ImGui::Selectable(shown.c_str(), is_selected, ImGuiSelectableFlags_SpanAllColumns)) session.selection = part;
}

bool ResultRow::choice(const std::string& name, bool is_chosen)
{
    return begin_cell(name) &&
           ImGui::Selectable((name + "###choice").c_str(), is_chosen, ImGuiSelectableFlags_SpanAllColumns);
}

void ResultRow::number(const std::string& text)
{
    if (begin_cell(text)) right_aligned(text);
}

void ResultRow::number(Workspace& workspace, const std::string& text, const PointedNumber& number,
                       const std::optional<Part>& part)
{
    if (!begin_cell(text)) return;
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

void ResultRow::name(const std::string& text)
{
    if (begin_cell(text)) ImGui::TextUnformatted(text.c_str());
}

// Without widths of ours Dear ImGui would have them from what stood in the columns in the frame before.
void result_list(const char* id, const std::vector<std::string>& headings, std::size_t n_rows,
                 const std::function<void(ResultRow&, std::size_t)>& row)
{
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_ScrollX |
                                      ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit;
    constexpr std::size_t most_rows = 12; // in sight, the headings counted
    const float line = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    ResultColumns columns(headings, row);
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const unsigned top = ImGui::GetID((std::string(id) + " top").c_str());
    const auto first = static_cast<std::size_t>(kept.GetInt(top)); // in sight, in the frame before
    for (std::size_t i = std::min(first, n_rows); i < std::min(n_rows, first + most_rows); ++i) columns.measure(i);
    if (n_rows > 0) columns.measure(0);
    const float side_bar = n_rows + 1 > most_rows ? ImGui::GetStyle().ScrollbarSize : 0.0F;
    const bool is_too_wide = columns.all() + side_bar > ImGui::GetContentRegionAvail().x;
    const float bar = is_too_wide ? ImGui::GetStyle().ScrollbarSize : 0.0F;
    const float height = static_cast<float>(std::min(n_rows + 1, most_rows)) * line + bar + 2.0F;
    if (!ImGui::BeginTable(id, static_cast<int>(headings.size()), flags, {0.0F, height})) return;
    ImGui::TableSetupScrollFreeze(1, 1);
    for (std::size_t j = 0; j < headings.size(); ++j)
        ImGui::TableSetupColumn(headings[j].c_str(), ImGuiTableColumnFlags_WidthFixed, columns.width(j));
    ImGui::TableHeadersRow();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(n_rows));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::TableNextRow();
            ImGui::PushID(i);
            columns.draw(static_cast<std::size_t>(i));
            ImGui::PopID();
        }
    }
    const auto top_row = static_cast<int>(ImGui::GetScrollY() / line);
    ImGui::EndTable();
    kept.SetInt(top, top_row);
}

bool result_section(const std::string& title, const char* id)
{
    return ImGui::CollapsingHeader((title + "###" + id).c_str(), ImGuiTreeNodeFlags_DefaultOpen);
}

} // namespace frame
