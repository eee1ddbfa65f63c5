// How a grid is drawn: the rows in sight, the headings and the first column that stay, the cursor and its editor.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "apps/frame/window/table_grid.h"

namespace frame {

void TableGrid::scroll_to_cursor()
{
    const float frozen = layout_.gutter + (n_columns_ > 0 ? layout_.widths[0] : 0.0F);
    const float x = x_of(cursor_.column), y = layout_.line * static_cast<float>(cursor_.row);
    const float width = layout_.widths[cursor_.column];
    if (cursor_.column > 0 && x - ImGui::GetScrollX() < frozen) ImGui::SetScrollX(x - frozen);
    if (x + width - ImGui::GetScrollX() > layout_.view_width) ImGui::SetScrollX(x + width - layout_.view_width);
    if (cursor_.column == 0) ImGui::SetScrollX(0.0F);
    const float seen = layout_.view_height - 2.0F * layout_.line;
    if (y < ImGui::GetScrollY()) ImGui::SetScrollY(y);
    if (y > ImGui::GetScrollY() + seen) ImGui::SetScrollY(y - seen);
}

namespace {

struct Frame {
    ImVec2 min, max;
};

// Numbers stand at the right, words at the left; what is too long is cut by the cell.
void write(const Frame& cell, const std::string& text, bool is_number, ImU32 color)
{
    const float pad = 0.5F * ImGui::GetFontSize();
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float x = is_number ? cell.max.x - pad - width : cell.min.x + pad;
    const float y = cell.min.y + 0.5F * (cell.max.y - cell.min.y - ImGui::GetTextLineHeight());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(cell.min, cell.max, true);
    list.AddText({x, y}, color, text.c_str());
    list.PopClipRect();
}

} // namespace

void TableGrid::draw(const Look& look) const
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float body = layout_.view_top + layout_.line;
    list.PushClipRect({layout_.view_left, body},
                      {layout_.view_left + layout_.view_width, layout_.view_top + layout_.view_height}, true);
    const auto first = static_cast<std::size_t>(std::max(0.0F, (body - layout_.top) / layout_.line));
    const auto n_seen = static_cast<std::size_t>(layout_.view_height / layout_.line) + 2;
    for (std::size_t row = first; row < std::min(n_rows_, first + n_seen); ++row) draw_row(look, row);
    draw_cursor();
    list.PopClipRect();
    draw_headings(look.table);
}

void TableGrid::draw_row(const Look& look, std::size_t row) const
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = layout_.top + layout_.line * static_cast<float>(row);
    const float right = layout_.view_left + layout_.view_width;
    const bool is_new = row >= order_.size();
    const bool is_selected = !is_new && look.is_selected(order_[row]);
    const ImU32 paper = ImGui::GetColorU32(ImGuiCol_PopupBg);
    const ImU32 tint = is_selected    ? ImGui::GetColorU32(ImGuiCol_Header, 0.55F)
                       : row % 2 == 1 ? ImGui::GetColorU32(ImGuiCol_TableRowBgAlt)
                                      : 0U;
    list.AddRectFilled({layout_.view_left, y}, {right, y + layout_.line}, tint);
    const std::size_t top = std::min(cursor_.row, anchor_.row), bottom = std::max(cursor_.row, anchor_.row);
    const std::size_t left_column = std::min(cursor_.column, anchor_.column);
    const std::size_t right_column = std::max(cursor_.column, anchor_.column);
    const auto cell = [&](std::size_t j, float x) {
        const Frame frame{{x, y}, {x + layout_.widths[j], y + layout_.line}};
        const bool is_in_block = row >= top && row <= bottom && j >= left_column && j <= right_column;
        if (is_in_block && !is_single())
            list.AddRectFilled(frame.min, frame.max, ImGui::GetColorU32(ImGuiCol_TextSelectedBg));
        const Heading& heading = look.table.headings[j];
        const bool is_derived = look.can_grow && !heading.is_editable;
        write(frame, shown_text(look.table, {row, j}), heading.is_number(),
              ImGui::GetColorU32(is_derived ? ImGuiCol_TextDisabled : ImGuiCol_Text));
    };
    const float frozen = layout_.view_left + layout_.gutter;
    for (std::size_t j = 1; j < n_columns_; ++j) {
        const float x = layout_.left + x_of(j);
        if (x + layout_.widths[j] > frozen + layout_.widths[0] && x < right) cell(j, x);
    }
    const Frame head{{layout_.view_left, y}, {frozen + layout_.widths[0], y + layout_.line}};
    list.AddRectFilled(head.min, head.max, paper);
    list.AddRectFilled(head.min, head.max, tint);
    write({head.min, {frozen, head.max.y}}, is_new ? "+" : std::to_string(row + 1), true,
          ImGui::GetColorU32(ImGuiCol_TextDisabled));
    cell(0, frozen);
}

void TableGrid::draw_headings(const Table& table) const
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = layout_.view_top, bottom = y + layout_.line;
    const float right = layout_.view_left + layout_.view_width;
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
    const ImU32 paper = ImGui::GetColorU32(ImGuiCol_TableHeaderBg);
    list.AddRectFilled({layout_.view_left, y}, {right, bottom}, paper);
    const auto heading = [&](std::size_t j, float x) {
        const float room = sorted_by_ == j ? ImGui::GetFontSize() : 0.0F;
        const Frame frame{{x, y}, {x + layout_.widths[j], bottom}};
        write({{x + (table.headings[j].is_number() ? room : 0.0F), y}, frame.max}, table.headings[j].column.label(),
              table.headings[j].is_number(), ink);
        if (sorted_by_ != j) return;
        const float r = 0.25F * ImGui::GetFontSize(), sign = is_descending_ ? 1.0F : -1.0F;
        const float side = table.headings[j].is_number() ? x + 3.0F * r : frame.max.x - 3.0F * r;
        const ImVec2 c{side, 0.5F * (y + bottom)};
        const ImVec2 tip{c.x, c.y + sign * r}, a{c.x - r, c.y - sign * r}, b{c.x + r, c.y - sign * r};
        list.AddTriangleFilled(tip, a, b, ink);
    };
    const float frozen = layout_.view_left + layout_.gutter;
    list.PushClipRect({frozen + layout_.widths[0], y}, {right, bottom}, true);
    for (std::size_t j = 1; j < n_columns_; ++j) heading(j, layout_.left + x_of(j));
    list.PopClipRect();
    heading(0, frozen);
    list.AddLine({layout_.view_left, bottom}, {right, bottom}, ImGui::GetColorU32(ImGuiCol_Border));
    list.AddLine({frozen + layout_.widths[0], y}, {frozen + layout_.widths[0], layout_.view_top + layout_.view_height},
                 ImGui::GetColorU32(ImGuiCol_Border));
}

void TableGrid::draw_cursor() const
{
    if (n_rows_ == 0) return;
    const float frozen = layout_.view_left + layout_.gutter;
    const float x = cursor_.column == 0 ? frozen : layout_.left + x_of(cursor_.column);
    if (cursor_.column > 0 && x < frozen + layout_.widths[0] - 1.0F) return;
    const float y = layout_.top + layout_.line * static_cast<float>(cursor_.row);
    ImGui::GetWindowDrawList()->AddRect({x, y}, {x + layout_.widths[cursor_.column], y + layout_.line},
                                        ImGui::GetColorU32(ImGuiCol_CheckMark), 0.0F, 0, 2.0F);
}

namespace {

// Dear ImGui selects the whole text of a field that gets the keyboard; here one types on.
int put_caret_at_end(ImGuiInputTextCallbackData* data)
{
    bool& is_fresh = *static_cast<bool*>(data->UserData);
    if (!is_fresh) return 0;
    data->ClearSelection();
    data->CursorPos = data->BufTextLen;
    is_fresh = false;
    return 0;
}

} // namespace

void TableGrid::show_editor()
{
    const float frozen = layout_.view_left + layout_.gutter;
    const float x = cursor_.column == 0 ? frozen : layout_.left + x_of(cursor_.column);
    const float pad = ImGui::GetFontSize();
    ImGui::SetCursorScreenPos({x, layout_.top + layout_.line * static_cast<float>(cursor_.row)});
    ImGui::SetNextItemWidth(
        std::max(layout_.widths[cursor_.column], ImGui::CalcTextSize(text_.c_str()).x + 2.0F * pad));
    if (is_fresh_) ImGui::SetKeyboardFocusHere();
    ImGui::PushStyleColor(ImGuiCol_FrameBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1.0F);
    ImGui::PushID(n_openings_); // an editor of its own: Dear ImGui would undo what was typed into the one before
    ImGui::InputText("###cell", &text_, ImGuiInputTextFlags_AllowTabInput | ImGuiInputTextFlags_CallbackAlways,
                     put_caret_at_end, &is_fresh_);
    ImGui::PopID();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

} // namespace frame
