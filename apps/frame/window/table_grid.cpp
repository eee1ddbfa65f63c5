#include "apps/frame/window/table_grid.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace frame {

using ui::Key;

void TableGrid::reset()
{
    const int n_openings = n_openings_;
    *this = TableGrid();
    n_openings_ = n_openings;
    must_scroll_ = true;
}

void TableGrid::follow(const Table& table, bool can_grow)
{
    if (order_.size() != table.rows.size()) {
        order_ = sorted_by_ ? sorted_rows(table, *sorted_by_) : whole(table).rows;
        if (is_descending_) std::ranges::reverse(order_);
    }
    n_columns_ = table.headings.size();
    n_rows_ = table.rows.size() + (can_grow ? 1 : 0);
    draft.resize(n_columns_);
    for (Place* const place : {&cursor_, &anchor_}) {
        place->row = std::min(place->row, n_rows_ > 0 ? n_rows_ - 1 : 0);
        place->column = std::min(place->column, n_columns_ - 1);
    }
    measure(table);
}

void TableGrid::measure(const Table& table)
{
    const float pad = ImGui::GetFontSize();
    layout_.line = ImGui::GetFrameHeight();
    layout_.gutter = ImGui::CalcTextSize(std::to_string(n_rows_).c_str()).x + pad;
    layout_.widths.assign(n_columns_, 0.0F);
    for (std::size_t j = 0; j < n_columns_; ++j) {
        float width = ImGui::CalcTextSize(table.headings[j].label.c_str()).x + pad; // room for the sort's triangle
        for (const Row& row : table.rows) width = std::max(width, ImGui::CalcTextSize(row.cells[j].shown.c_str()).x);
        layout_.widths[j] = std::max(width, 3.0F * pad) + pad;
    }
}

void TableGrid::go_to(std::size_t row)
{
    const auto found = std::ranges::find(order_, row);
    if (found == order_.end()) return;
    cursor_.row = anchor_.row = static_cast<std::size_t>(found - order_.begin());
    must_scroll_ = true;
}

// ---- blocks ----

std::size_t TableGrid::first_row() const { return std::min(cursor_.row, anchor_.row); }

std::size_t TableGrid::n_rows_of_block() const { return std::max(cursor_.row, anchor_.row) - first_row() + 1; }

bool TableGrid::is_single() const { return cursor_ == anchor_; }

CellBlock TableGrid::block() const
{
    CellBlock block{{}, std::min(cursor_.column, anchor_.column), std::max(cursor_.column, anchor_.column)};
    for (std::size_t row = first_row(); row < first_row() + n_rows_of_block() && row < order_.size(); ++row)
        block.rows.push_back(order_[row]);
    return block;
}

bool TableGrid::has_whole_rows(const Table& table) const
{
    const CellBlock chosen = block();
    return !chosen.rows.empty() && chosen.first_column == 0 && chosen.last_column + 1 == table.headings.size();
}

std::optional<GridEdit> TableGrid::take_edit() { return std::exchange(edit_, std::nullopt); }

// ---- keyboard ----

std::string TableGrid::typed_text(const Table& table, Place place) const
{
    if (place.row >= order_.size()) return draft[place.column];
    return table.rows[order_[place.row]].cells[place.column].typed;
}

std::string TableGrid::shown_text(const Table& table, Place place) const
{
    if (place.row >= order_.size()) return draft[place.column];
    return table.rows[order_[place.row]].cells[place.column].shown;
}

void TableGrid::open(std::string text)
{
    text_ = std::move(text);
    is_editing_ = is_fresh_ = must_scroll_ = true;
    ++n_openings_;
    anchor_ = cursor_;
}

void TableGrid::confirm(Way then)
{
    is_editing_ = false;
    ImGui::ClearActiveID();
    then_ = then;
    edit_ = GridEdit{cursor_.row, cursor_.column, {{text_}}};
}

void TableGrid::reject(const GridEdit& edit)
{
    cursor_ = {edit.row, edit.column};
    open(edit.texts.front().front());
}

void TableGrid::accept() { move(std::exchange(then_, Way::Stay), false); }

void TableGrid::move(Way way, bool extends)
{
    if (way == Way::Down && cursor_.row + 1 < n_rows_) ++cursor_.row;
    if (way == Way::Up && cursor_.row > 0) --cursor_.row;
    if (way == Way::Right && cursor_.column + 1 < n_columns_) ++cursor_.column;
    if (way == Way::Left && cursor_.column > 0) --cursor_.column;
    if (!extends) anchor_ = cursor_;
    must_scroll_ = true;
}

void TableGrid::type(std::string_view letters, const Table& table)
{
    if (letters.empty() || n_rows_ == 0) return;
    if (!is_editing_ && table.headings[cursor_.column].is_editable) open("");
    if (!is_editing_ || !is_fresh_) return; // an editor with the keyboard reads for itself
    text_ += letters;
    ImGui::GetIO().InputQueueCharacters.resize(0);
}

bool TableGrid::take(const ui::Chord& chord, const Table& table)
{
    if (is_editing_) return take_editing(chord);
    const bool has_no_modifier = chord.modifiers == ui::no_modifiers;
    if (chord.key == Key::F2 && has_no_modifier && n_rows_ > 0) {
        if (table.headings[cursor_.column].is_editable) open(typed_text(table, cursor_));
        return true;
    }
    if (chord == ui::Chord{Key::A, ui::ctrl}) {
        anchor_ = {};
        cursor_ = {order_.empty() ? 0 : order_.size() - 1, n_columns_ - 1};
        return true;
    }
    return take_moving(chord);
}

bool TableGrid::take_editing(const ui::Chord& chord)
{
    const bool has_shift = chord.modifiers.shift;
    switch (chord.key) {
    case Key::Enter: confirm(has_shift ? Way::Up : Way::Down); return true;
    case Key::Tab: confirm(has_shift ? Way::Left : Way::Right); return true;
    case Key::Escape:
        is_editing_ = false;
        ImGui::ClearActiveID();
        return true;
    default: return !chord.modifiers.ctrl && (chord.key < Key::F1 || chord.key > Key::F12); // the editor's own
    }
}

bool TableGrid::take_moving(const ui::Chord& chord)
{
    const bool extends = chord.modifiers.shift;
    if (chord.modifiers.alt) return false;
    const auto jump = [&](Place to) {
        cursor_ = to;
        if (!extends) anchor_ = cursor_;
        must_scroll_ = true;
        return true;
    };
    const std::size_t last_row = n_rows_ > 0 ? n_rows_ - 1 : 0;
    const std::size_t page = static_cast<std::size_t>(
        std::max(1.0F, layout_.view_height / std::max(1.0F, layout_.line) - 2.0F));
    const bool has_ctrl = chord.modifiers.ctrl;
    switch (chord.key) {
    case Key::Up: return has_ctrl ? jump({0, cursor_.column}) : (move(Way::Up, extends), true);
    case Key::Down: return has_ctrl ? jump({last_row, cursor_.column}) : (move(Way::Down, extends), true);
    case Key::Left: return has_ctrl ? jump({cursor_.row, 0}) : (move(Way::Left, extends), true);
    case Key::Right: return has_ctrl ? jump({cursor_.row, n_columns_ - 1}) : (move(Way::Right, extends), true);
    case Key::Enter: move(extends ? Way::Up : Way::Down, false); return true;
    case Key::Tab: move(extends ? Way::Left : Way::Right, false); return true;
    case Key::Home: return jump({has_ctrl ? 0 : cursor_.row, 0});
    case Key::End: return jump({has_ctrl ? last_row : cursor_.row, n_columns_ - 1});
    case Key::PageUp: return jump({cursor_.row - std::min(page, cursor_.row), cursor_.column});
    case Key::PageDown: return jump({std::min(cursor_.row + page, last_row), cursor_.column});
    default: return false;
    }
}

// ---- mouse ----

float TableGrid::x_of(std::size_t column) const
{
    float x = layout_.gutter;
    for (std::size_t j = 0; j < column; ++j) x += layout_.widths[j];
    return x;
}

std::optional<TableGrid::Place> TableGrid::place_under_mouse() const
{
    const ImVec2 mouse = ImGui::GetMousePos();
    const float x = mouse.x - layout_.left;
    const float y = std::max(mouse.y, layout_.view_top + layout_.line) - layout_.top;
    if (n_rows_ == 0) return std::nullopt;
    std::size_t column = 0;
    while (column + 1 < n_columns_ && x >= x_of(column + 1)) ++column;
    const auto row = static_cast<std::size_t>(std::max(0.0F, y / layout_.line));
    return Place{std::min(row, n_rows_ - 1), column};
}

void TableGrid::sort_by(const Table& table, std::size_t column)
{
    is_descending_ = sorted_by_ == column && !is_descending_;
    sorted_by_ = column;
    order_ = sorted_rows(table, column);
    if (is_descending_) std::ranges::reverse(order_);
}

void TableGrid::take_mouse(const Table& table)
{
    was_clicked_ = false;
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) is_dragging_ = false;
    const ImVec2 mouse = ImGui::GetMousePos();
    const std::optional<Place> place = place_under_mouse();
    if (is_dragging_ && place && !is_editing_) cursor_ = *place;
    const bool is_over = ImGui::IsWindowHovered() && mouse.x < layout_.view_left + layout_.view_width &&
                         mouse.y < layout_.view_top + layout_.view_height;
    if (!is_over || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
    was_clicked_ = true;
    const bool is_heading = mouse.y < layout_.view_top + layout_.line;
    const bool is_in_editor = is_editing_ && place == cursor_ && !is_heading;
    if (is_in_editor) return;
    if (is_editing_) confirm(Way::Stay);
    if (is_heading) {
        if (place && mouse.x > layout_.view_left + layout_.gutter) sort_by(table, place->column);
        return;
    }
    if (!place) return;
    const bool is_row = mouse.x < layout_.view_left + layout_.gutter;
    const bool extends = ImGui::GetIO().KeyShift;
    cursor_ = is_row ? Place{place->row, n_columns_ - 1} : *place;
    if (!extends) anchor_ = is_row ? Place{place->row, 0} : *place;
    is_dragging_ = !is_row;
    const bool is_double = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !is_row;
    if (is_double && table.headings[place->column].is_editable) open(typed_text(table, *place));
}

// ---- picture ----

void TableGrid::show(const Look& look, float footer)
{
    follow(look.table, look.can_grow);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
    ImGui::BeginChild("###grid", {0.0F, std::max(room.y - footer, 3.0F * layout_.line)}, true,
                      ImGuiWindowFlags_HorizontalScrollbar);
    const ImGuiWindow& window = *ImGui::GetCurrentWindow();
    layout_.view_left = window.InnerRect.Min.x;
    layout_.view_top = window.InnerRect.Min.y;
    layout_.view_width = window.InnerRect.GetWidth();
    layout_.view_height = window.InnerRect.GetHeight();
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    layout_.left = origin.x;
    layout_.top = origin.y + layout_.line;
    take_mouse(look.table);
    draw(look);
    if (is_editing_) show_editor();
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy({x_of(n_columns_), layout_.line * static_cast<float>(n_rows_ + 1)});
    if (std::exchange(must_scroll_, false)) scroll_to_cursor();
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
}

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
        write(frame, shown_text(look.table, {row, j}), heading.is_number,
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
        write({{x + (table.headings[j].is_number ? room : 0.0F), y}, frame.max}, table.headings[j].label,
              table.headings[j].is_number, ink);
        if (sorted_by_ != j) return;
        const float r = 0.25F * ImGui::GetFontSize(), sign = is_descending_ ? 1.0F : -1.0F;
        const float side = table.headings[j].is_number ? x + 3.0F * r : frame.max.x - 3.0F * r;
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
