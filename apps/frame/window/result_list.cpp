#include "apps/frame/window/result_list.h"
#include "ui/widgets/item_label.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace frame {

namespace {

constexpr std::size_t most_lines = 12; ///< in sight, the headings counted

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
    ResultColumns(const std::vector<std::string>& headings, const FillRow& row) : headings_(headings), row_(row)
    {
        for (const std::string& heading : headings)
            widths_.push_back(ImGui::CalcTextSize(heading.c_str(), nullptr, true).x);
    }

    void measure(std::size_t i)
    {
        ResultRow cells(&widths_, false);
        row_(cells, i);
    }
    /// \param width  for all of them, and for the bar that scrolls rows of which not all are in sight
    void fit(float width, std::size_t n_rows)
    {
        const auto room = [&](std::size_t n_lines) {
            return width - (n_lines >= most_lines ? ImGui::GetStyle().ScrollbarSize : 0.0F);
        };
        const bool is_too_wide = all() > room(n_rows);
        is_stacked_ = is_too_wide && widths_.size() > 1 && std::max(widths_.front(), numbers()) <= room(2 * n_rows);
        is_scrolled_ = is_too_wide && !is_stacked_;
    }
    bool is_stacked() const { return is_stacked_; }
    bool is_scrolled() const { return is_scrolled_; }
    float row_height() const
    {
        const ImGuiStyle& style = ImGui::GetStyle();
        const float line = ImGui::GetTextLineHeight();
        return 2.0F * style.CellPadding.y + (is_stacked_ ? 2.0F * line + style.ItemSpacing.y : line);
    }
    int n_columns() const { return static_cast<int>(widths_.size()) - n_above(); }
    void set_up() const
    {
        ImGui::TableSetupScrollFreeze(is_stacked_ ? 0 : 1, 1);
        for (auto j = static_cast<std::size_t>(n_above()); j < widths_.size(); ++j)
            ImGui::TableSetupColumn(headings_[j].c_str(), ImGuiTableColumnFlags_WidthFixed, widths_[j]);
        ImGui::TableHeadersRow();
    }
    void draw(std::size_t i) const
    {
        ResultRow cells(nullptr, is_stacked_);
        row_(cells, i);
    }

private:
    int n_above() const { return is_stacked_ ? 1 : 0; }
    float from(std::size_t column) const
    {
        const auto first = static_cast<std::ptrdiff_t>(column);
        const float gaps = 2.0F * ImGui::GetStyle().CellPadding.x * static_cast<float>(widths_.size() - column - 1);
        return std::accumulate(widths_.begin() + first, widths_.end(), gaps);
    }
    float all() const { return from(0); }
    float numbers() const { return from(1); }

    const std::vector<std::string>& headings_;
    const FillRow& row_;
    std::vector<float> widths_;
    bool is_stacked_ = false, is_scrolled_ = false;
};

bool ResultRow::begin_cell(const std::string& text)
{
    const std::size_t column = column_++;
    if (widths_ != nullptr) {
        float& width = (*widths_)[column];
        width = std::max(width, ImGui::CalcTextSize(text.c_str()).x);
        return false;
    }
    if (is_stacked_ && column == 1) return true; // below the first one
    ImGui::TableNextColumn();
    if (is_stacked_ && column > 1) ImGui::Dummy({0.0F, ImGui::GetTextLineHeight()});
    return true;
}

// Where it stands above the others it may be broader than the column that it begins in.
bool ResultRow::first_cell(const std::string& text, const char* id, bool is_chosen)
{
    if (!begin_cell(text)) return false;
    if (!is_stacked_) return ImGui::Selectable((text + id).c_str(), is_chosen, ImGuiSelectableFlags_SpanAllColumns);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool is_clicked = ImGui::Selectable((std::string("###") + id).c_str(), is_chosen,
                                              ImGuiSelectableFlags_SpanAllColumns);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low = list.GetClipRectMin(), high = list.GetClipRectMax();
    list.PushClipRect(low, {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(), high.y});
    list.AddText(corner, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    list.PopClipRect();
    return is_clicked;
}

void ResultRow::part(Session& session, const Part& part, const std::string& name)
{
    if (first_cell(ui::shown_whole(name), "", session.selection.contains(part))) session.selection = part;
}

bool ResultRow::choice(const std::string& name, bool is_chosen) { return first_cell(name, "###choice", is_chosen); }

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
    ResultColumns columns(headings, row);
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const unsigned top = ImGui::GetID((std::string(id) + " top").c_str());
    const auto first = static_cast<std::size_t>(kept.GetInt(top)); // in sight, in the frame before
    for (std::size_t i = std::min(first, n_rows); i < std::min(n_rows, first + most_lines); ++i) columns.measure(i);
    if (n_rows > 0) columns.measure(0);
    const float heading = columns.row_height();
    columns.fit(ImGui::GetContentRegionAvail().x, n_rows);
    const float line = columns.row_height();
    const float rows = std::min(static_cast<float>(n_rows) * line, static_cast<float>(most_lines - 1) * heading);
    const float bar = columns.is_scrolled() ? ImGui::GetStyle().ScrollbarSize : 0.0F;
    const float height = heading + rows + bar + 2.0F;
    if (!ImGui::BeginTable(id, columns.n_columns(), flags, {0.0F, height})) return;
    columns.set_up();
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
