// What the keyboard does in a grid: moving, choosing blocks, editing a cell.
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "apps/frame/window/table_grid.h"

namespace frame {

using ui::Key;

namespace {

/// Without those that fill a row, and those that write into a cell.
bool is_moving(Key key)
{
    using enum Key;
    constexpr std::array keys = {Up, Down, Left, Right, Home, End, PageUp, PageDown};
    return std::ranges::find(keys, key) != keys.end();
}

} // namespace

std::string TableGrid::typed_text(const Table& table, Place place) const
{
    if (place.row >= order_.size()) return draft[place.column];
    return table.rows[order_[place.row]].cells[place.column].typed;
}

std::string TableGrid::shown_text(const Table& table, Place place) const
{
    if (place.row >= order_.size()) return draft[place.column];
    return table.rows[order_[place.row]].cells[place.column].value.shown;
}

void TableGrid::open(std::string text)
{
    text_ = std::move(text);
    is_editing_ = is_fresh_ = must_scroll_ = true;
    ++n_openings_;
    anchor_ = cursor_;
}

void TableGrid::confirm(Direction then)
{
    is_editing_ = false;
    ImGui::ClearActiveID();
    then_ = then;
    if (cursor_.row >= order_.size()) tabs_from_ = 0; // a new row is filled from its first cell
    edit_ = GridEdit{cursor_.row, cursor_.column, {{text_}}};
}

void TableGrid::settle()
{
    if (is_editing_) confirm(Direction::Stay);
}

void TableGrid::reject(const GridEdit& edit)
{
    cursor_ = {edit.row, edit.column};
    open(edit.texts.front().front());
}

void TableGrid::accept() { advance(std::exchange(then_, Direction::Stay)); }

// By Tab and Enter, which fill one row after the other from the same column.
void TableGrid::advance(Direction way)
{
    if (way == Direction::Right && !tabs_from_) tabs_from_ = cursor_.column;
    const bool ends_row = way == Direction::Down && cursor_.row + 1 < n_rows_;
    if (ends_row && tabs_from_) cursor_.column = *tabs_from_;
    if (way == Direction::Down || way == Direction::Up) tabs_from_.reset();
    move(way, false);
}

void TableGrid::move(Direction way, bool extends)
{
    if (way == Direction::Down && cursor_.row + 1 < n_rows_) ++cursor_.row;
    if (way == Direction::Up && cursor_.row > 0) --cursor_.row;
    if (way == Direction::Right && cursor_.column + 1 < n_columns_) ++cursor_.column;
    if (way == Direction::Left && cursor_.column > 0) --cursor_.column;
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

bool TableGrid::handle_key(const ui::Chord& chord, const Table& table)
{
    if (is_editing_) return handle_editing_key(chord);
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
    return handle_moving_key(chord);
}

bool TableGrid::handle_editing_key(const ui::Chord& chord)
{
    const bool has_shift = chord.modifiers.shift;
    if (chord.key == Key::Tab && chord.modifiers.ctrl) return false; // to another document
    switch (chord.key) {
    case Key::Enter: confirm(has_shift ? Direction::Up : Direction::Down); return true;
    case Key::Tab: confirm(has_shift ? Direction::Left : Direction::Right); return true;
    case Key::Escape:
        is_editing_ = false;
        ImGui::ClearActiveID();
        return true;
    default: return !chord.modifiers.ctrl && !ui::is_function_key(chord.key); // the editor's own
    }
}

bool TableGrid::handle_moving_key(const ui::Chord& chord)
{
    const bool extends = chord.modifiers.shift;
    if (chord.modifiers.alt) return false;
    if (is_moving(chord.key)) tabs_from_.reset();
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
    case Key::Up: return has_ctrl ? jump({0, cursor_.column}) : (move(Direction::Up, extends), true);
    case Key::Down: return has_ctrl ? jump({last_row, cursor_.column}) : (move(Direction::Down, extends), true);
    case Key::Left: return has_ctrl ? jump({cursor_.row, 0}) : (move(Direction::Left, extends), true);
    case Key::Right: return has_ctrl ? jump({cursor_.row, n_columns_ - 1}) : (move(Direction::Right, extends), true);
    case Key::Enter: advance(extends ? Direction::Up : Direction::Down); return true;
    case Key::Tab: return !has_ctrl && (advance(extends ? Direction::Left : Direction::Right), true);
    case Key::Home: return jump({has_ctrl ? 0 : cursor_.row, 0});
    case Key::End: return jump({has_ctrl ? last_row : cursor_.row, n_columns_ - 1});
    case Key::PageUp: return jump({cursor_.row - std::min(page, cursor_.row), cursor_.column});
    case Key::PageDown: return jump({std::min(cursor_.row + page, last_row), cursor_.column});
    default: return false;
    }
}

} // namespace frame
