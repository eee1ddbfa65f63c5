#pragma once

#include "femoop/tabular/table.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace drawing {

/// The table with no more rows than that beside its sums. \pre more than 0
using TableOfRows = std::function<tabular::Table(std::size_t most_rows)>;

/// Where a table has to stand.
struct TableRoom {
    double width, height; ///< at most [logical pixels]
    /// Columns whose cells may stand below the rest of their row: the first of them, or all.
    std::vector<std::size_t> folded{};
    /// Columns of formulas that may end with "+ …" where smaller type could not be read.
    std::vector<std::size_t> shortened{};
};

/// A table at the foot of a sheet, in the largest type of the theme's in which its rows stand in one line each; where none
/// is small enough, one column is folded below the others, or several, and where that is too wide formulas are shortened.
/// It has as many rows as there is room for.
///
///     member        x [m]   F(x)       f(x)       stiffness          work [m]
///     -----------------------------------------------------------------------
///     BC       M    0 … 4   -42.7 + x  0.63 - x   EI = 48573        -0.002139
///              F f = -27 + 5.3 x
///     -----------------------------------------------------------------------
///     sum                                                           -0.002139
class SheetTable {
public:
    SheetTable(const TableOfRows& table, const TableRoom& room, const ui::Theme& theme, const ui::Fonts& fonts);

    double height() const;                  ///< with a line free above it
    double width() const { return width_; } ///< more than there is room for where no type is small enough
    void draw(ui::Painter& painter, ui::Point corner) const;

private:
    void choose_type(const ui::Fonts& fonts);
    void lay_out(const ui::Fonts& fonts);
    void shorten_columns(const ui::Fonts& fonts);
    void shorten_below(tabular::Row& row, const ui::Fonts& fonts);
    void fit_in_width(const ui::Fonts& fonts);
    double width_per_shortened() const;
    bool is_in_line(std::size_t column) const;
    std::string folded_text(const tabular::Row& row) const;
    std::size_t lines_of(const tabular::Row& row) const;
    double line_height() const;
    std::size_t n_lines() const;
    ui::TextStyle style(bool is_heading, ui::Anchor anchor) const;
    void draw_row(ui::Painter& painter, const tabular::Row& row, ui::Point at, bool is_sum) const;
    void draw_rule(ui::Painter& painter, ui::Point at) const;

    TableRoom room_;
    ui::Theme theme_;
    tabular::Table table_;
    std::vector<double> lefts_, widths_; ///< of the columns
    double width_ = 0.0;
    double size_ = 0.0;        ///< of the type
    std::size_t n_folded_ = 0; ///< of the columns that may be
};

} // namespace drawing
