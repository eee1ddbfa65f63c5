#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/frame/tables/table.h"
#include "ui/command/chord.h"

namespace frame {

/// Texts that somebody wants in the cells, from a first one on; rows and columns as they are seen.
struct GridEdit {
    std::size_t row = 0, column = 0;
    TextBlock texts;
};

/// A spreadsheet: shows a table and says what is done to it with mouse and keyboard. It changes nothing by itself.
///
///     click, arrows: a cell       Shift, drag: a block      row number: a row      heading: sort, again: the other way
///     a letter, F2, double click: edit      Enter: down      Tab: right      Esc: the cell as it was
///
/// Enter after Tabs goes to where they began, one row down; after a new row that is its first cell.
class TableGrid {
public:
    struct Look {
        const Table& table;
        bool can_grow = false; ///< an empty row at the end takes new ones
        std::function<bool(std::size_t row)> is_selected;
    };

    /// Fills what is left of the current window of Dear ImGui's but `footer` [physical pixels].
    void show(const Look& look, float footer);

    /// The cell under the mouse, by the table's rows; nothing beside the cells and over the row for new ones.
    std::optional<std::pair<std::size_t, std::size_t>> cell_under_mouse() const { return under_mouse_; }
    /// That of the cursor, likewise.
    std::optional<std::pair<std::size_t, std::size_t>> cell_of_cursor() const { return cell_of_table(cursor_); }
    void go_to_mouse(); ///< the cursor, where a cell is under it

    /// A key that went down; false where the grid has no use for it.
    bool handle_key(const ui::Chord& chord, const Table& table);
    void type(std::string_view letters, const Table& table);

    void settle(); ///< what is half typed is confirmed
    /// What is asked for since it was asked last.
    std::optional<GridEdit> apply_edit();
    bool takes_clicks() const { return was_clicked_; } ///< the mouse pressed in the grid in this frame

    /// The text that was confirmed cannot be taken: its cell is opened again with it.
    void reject(const GridEdit& edit);
    /// The text that was confirmed was taken: on to the next cell.
    void accept();

    /// Starts over, as for another table.
    void reset();
    /// Makes the grid fit a table that has changed.
    void follow(const Table& table, bool can_grow);
    /// Every row is seen where it was, one that was removed and comes back too, and new ones at the end, though the table
    /// may list them in another order now: what is typed next goes on in the same row. \param order  in which the rows of `before` were seen
    /// \returns whether rows came back, to which the cursor goes
    bool keep_places(const Table& before, const std::vector<std::size_t>& order, const Table& now);
    /// Goes to a row of the table (not as it is seen); to the cell of a column, where one is named.
    void go_to(std::size_t row, std::optional<std::size_t> column = std::nullopt);

    bool is_editing() const { return is_editing_; }
    /// Rows in the order in which they are seen; those of the block lie within the table.
    const std::vector<std::size_t>& order() const { return order_; }
    CellBlock block() const;
    std::size_t first_row() const; ///< of the block, as it is seen
    bool has_whole_rows(const Table& table) const;
    bool is_single() const;
    std::size_t n_rows_of_block() const; ///< the one for new rows counted too
    std::size_t column() const { return cursor_.column; }

    /// Texts of the row at the end, until it is complete.
    std::vector<std::string> draft;

private:
    struct Place {
        std::size_t row = 0, column = 0;
        friend bool operator==(const Place&, const Place&) = default;
    };
    /// A row that is seen no more.
    struct GoneRow {
        std::string text{};
        std::size_t place = 0; ///< in which it was seen
        std::size_t row = 0;   ///< of the table, where it is back
    };
    enum class Direction { Stay, Down, Right, Up, Left };

    std::vector<GoneRow> rows_that_are_back(const Table& now, std::vector<bool>& is_placed);
    void go_to_rows(std::size_t first, std::size_t last);
    void measure(const Table& table);
    void handle_mouse(const Table& table);
    std::optional<Place> place_under_mouse() const;
    std::optional<std::pair<std::size_t, std::size_t>> cell_of_table(Place place) const;
    void sort_by(const Table& table, std::size_t column);
    std::vector<std::size_t> sorted(const Table& table) const; ///< its rows, as is chosen by a heading
    void draw(const Look& look) const;
    void draw_row(const Look& look, std::size_t row) const;
    void draw_headings(const Table& table) const;
    void draw_cursor() const;
    void show_editor();
    void scroll_to_cursor();
    void open(std::string text);
    void confirm(Direction then);
    void move(Direction way, bool extends);
    void advance(Direction way);
    bool handle_editing_key(const ui::Chord& chord);
    bool handle_moving_key(const ui::Chord& chord);
    std::string typed_text(const Table& table, Place place) const;
    std::string shown_text(const Table& table, Place place) const;
    float x_of(std::size_t column) const;

    Place cursor_, anchor_;
    std::vector<std::size_t> order_;
    std::vector<GoneRow> gone_;
    std::optional<std::size_t> sorted_by_;
    bool is_descending_ = false;
    std::size_t n_rows_ = 0, n_columns_ = 0; ///< the row for new ones counted

    bool is_editing_ = false;
    bool is_fresh_ = false; ///< the editor has no keyboard yet
    int n_openings_ = 0;    ///< of the editor
    std::string text_;
    Direction then_ = Direction::Stay;
    std::optional<std::size_t> tabs_from_; ///< the column in which a row is filled from, by Tab
    std::optional<GridEdit> edit_;

    bool must_scroll_ = false;
    bool is_dragging_ = false;
    bool was_clicked_ = false;
    std::optional<std::pair<std::size_t, std::size_t>> under_mouse_;

    struct Layout {
        std::vector<float> widths;
        float gutter = 0.0F, line = 0.0F;
        float left = 0.0F, top = 0.0F;           ///< of the first cell on the screen, moved by the scrolling
        float view_left = 0.0F, view_top = 0.0F; ///< of what is seen, headings included
        float view_width = 0.0F, view_height = 0.0F;
    };
    Layout layout_;
};

} // namespace frame
