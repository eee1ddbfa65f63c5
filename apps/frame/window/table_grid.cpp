#include "apps/frame/window/table_grid.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace frame {

using ui::Key;

namespace {

/// All that is typed in a row: two rows with the same are one for who looks at them.
std::string text_of(const Row& row)
{
    std::string text;
    for (const Cell& cell : row.cells) text += cell.typed + '\n';
    return text;
}

/// The row of `now` that goes on at each place: what has not changed, then what was changed where it is listed.
std::vector<std::optional<std::size_t>> kept_rows(const Table& before, const std::vector<std::size_t>& order,
                                                  const Table& now)
{
    std::multimap<std::string, std::size_t> rows_by_text;
    for (std::size_t row = 0; row < now.rows.size(); ++row) rows_by_text.emplace(text_of(now.rows[row]), row);
    std::vector<std::optional<std::size_t>> kept(std::max(order.size(), now.rows.size()));
    std::vector<bool> is_placed(now.rows.size(), false);
    const auto put = [&](std::size_t place, std::size_t row) {
        kept[place] = row;
        is_placed[row] = true;
    };
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::string text = text_of(before.rows[order[i]]);
        const auto found = rows_by_text.lower_bound(text);
        if (found == rows_by_text.end() || found->first != text) continue;
        put(i, found->second);
        rows_by_text.erase(found);
    }
    for (std::size_t i = 0; i < order.size(); ++i)
        if (!kept[i] && order[i] < now.rows.size() && !is_placed[order[i]]) put(i, order[i]);
    return kept;
}

} // namespace

void TableGrid::reset()
{
    const int n_openings = n_openings_;
    *this = TableGrid();
    n_openings_ = n_openings;
    must_scroll_ = true;
}

void TableGrid::follow(const Table& table, bool can_grow)
{
    if (order_.size() != table.rows.size()) order_ = sorted(table);
    n_columns_ = table.headings.size();
    n_rows_ = table.rows.size() + (can_grow ? 1 : 0);
    draft.resize(n_columns_);
    for (Place* const place : {&cursor_, &anchor_}) {
        place->row = std::min(place->row, n_rows_ > 0 ? n_rows_ - 1 : 0);
        place->column = std::min(place->column, n_columns_ - 1);
    }
    measure(table);
}

bool TableGrid::keep_places(const Table& before, const std::vector<std::size_t>& order, const Table& now)
{
    const std::vector<std::optional<std::size_t>> kept = kept_rows(before, order, now);
    std::vector<bool> is_placed(now.rows.size(), false);
    for (const std::optional<std::size_t>& row : kept)
        if (row) is_placed[*row] = true;
    const std::vector<GoneRow> back = rows_that_are_back(now, is_placed);
    std::size_t next = 0; // of the others
    order_.clear();
    for (std::size_t i = 0; i < kept.size(); ++i) {
        while (!kept[i] && next < now.rows.size() && is_placed[next]) ++next;
        if (kept[i]) order_.push_back(*kept[i]);
        else if (next < now.rows.size()) order_.push_back(next++);
        else if (i < order.size()) gone_.push_back({.text = text_of(before.rows[order[i]]), .place = i});
    }
    for (const GoneRow& row : back)
        order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(std::min(row.place, order_.size())), row.row);
    if (sorted_by_ && order_ != sorted(now)) {
        sorted_by_.reset();
        is_descending_ = false;
    }
    if (!back.empty()) go_to_rows(back.front().row, back.back().row);
    return !back.empty();
}

/// By undo, in the order in which they were seen.
std::vector<TableGrid::GoneRow> TableGrid::rows_that_are_back(const Table& now, std::vector<bool>& is_placed)
{
    std::vector<GoneRow> back;
    for (std::size_t row = 0; row < now.rows.size(); ++row) {
        if (is_placed[row]) continue;
        const auto gone = std::ranges::find(gone_, text_of(now.rows[row]), &GoneRow::text);
        if (gone == gone_.end()) continue;
        is_placed[row] = true;
        back.push_back({.place = gone->place, .row = row});
        gone_.erase(gone);
    }
    std::ranges::sort(back, {}, &GoneRow::place);
    return back;
}

/// The cells of the block's columns from one row of the table to another.
void TableGrid::go_to_rows(std::size_t first, std::size_t last)
{
    const auto place_of = [&](std::size_t row) {
        return static_cast<std::size_t>(std::ranges::find(order_, row) - order_.begin());
    };
    cursor_.row = place_of(first);
    anchor_.row = place_of(last);
    must_scroll_ = true;
}

std::vector<std::size_t> TableGrid::sorted(const Table& table) const
{
    std::vector<std::size_t> order = sorted_by_ ? sorted_rows(table, *sorted_by_) : whole(table).rows;
    if (is_descending_) std::ranges::reverse(order);
    return order;
}

void TableGrid::measure(const Table& table)
{
    const float pad = ImGui::GetFontSize();
    layout_.line = ImGui::GetFrameHeight();
    layout_.gutter = ImGui::CalcTextSize(std::to_string(n_rows_).c_str()).x + pad;
    layout_.widths.assign(n_columns_, 0.0F);
    for (std::size_t j = 0; j < n_columns_; ++j) {
        float width = ImGui::CalcTextSize(table.headings[j].column.label().c_str()).x +
                      pad; // room for the sort's triangle
        for (const Row& row : table.rows)
            width = std::max(width, ImGui::CalcTextSize(row.cells[j].value.shown.c_str()).x);
        layout_.widths[j] = std::max(width, 3.0F * pad) + pad;
    }
}

void TableGrid::go_to(std::size_t row, std::optional<std::size_t> column)
{
    const auto found = std::ranges::find(order_, row);
    if (found == order_.end()) return;
    cursor_.row = anchor_.row = static_cast<std::size_t>(found - order_.begin());
    if (column && *column < n_columns_) cursor_.column = anchor_.column = *column;
    tabs_from_.reset();
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

std::optional<GridEdit> TableGrid::apply_edit() { return std::exchange(edit_, std::nullopt); }

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
    order_ = sorted(table);
}

std::optional<std::pair<std::size_t, std::size_t>> TableGrid::cell_of_table(Place place) const
{
    if (place.row >= order_.size()) return std::nullopt;
    return std::pair{order_[place.row], place.column};
}

void TableGrid::go_to_mouse()
{
    const std::optional<Place> place = place_under_mouse();
    if (place) cursor_ = anchor_ = *place;
}

void TableGrid::handle_mouse(const Table& table)
{
    was_clicked_ = false;
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) is_dragging_ = false;
    const ImVec2 mouse = ImGui::GetMousePos();
    const std::optional<Place> place = place_under_mouse();
    if (is_dragging_ && place && !is_editing_) cursor_ = *place;
    under_mouse_.reset();
    const bool is_over = ImGui::IsWindowHovered() && mouse.x < layout_.view_left + layout_.view_width &&
                         mouse.y < layout_.view_top + layout_.view_height;
    const bool is_heading = mouse.y < layout_.view_top + layout_.line;
    const bool is_in_gutter = mouse.x < layout_.view_left + layout_.gutter;
    if (is_over && place && !is_heading && !is_in_gutter) under_mouse_ = cell_of_table(*place);
    if (!is_over || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
    was_clicked_ = true;
    const bool is_in_editor = is_editing_ && place == cursor_ && !is_heading;
    if (is_in_editor) return;
    if (is_editing_) confirm(Direction::Stay);
    if (is_heading) {
        if (place && !is_in_gutter) sort_by(table, place->column);
        return;
    }
    if (!place) return;
    tabs_from_.reset();
    const bool extends = ImGui::GetIO().KeyShift;
    cursor_ = is_in_gutter ? Place{place->row, n_columns_ - 1} : *place;
    if (!extends) anchor_ = is_in_gutter ? Place{place->row, 0} : *place;
    is_dragging_ = !is_in_gutter;
    const bool is_double = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !is_in_gutter;
    if (is_double && table.headings[place->column].is_editable) open(typed_text(table, *place));
}

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
    handle_mouse(look.table);
    draw(look);
    if (is_editing_) show_editor();
    ImGui::SetCursorScreenPos(origin);
    ImGui::Dummy({x_of(n_columns_), layout_.line * static_cast<float>(n_rows_ + 1)});
    if (std::exchange(must_scroll_, false)) scroll_to_cursor();
    ImGui::EndChild();
    ImGui::PopStyleVar(2);
}

} // namespace frame
