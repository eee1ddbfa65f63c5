#include "apps/drawing/sheet/sheet_table.h"

#include "ui/text/number_format.h"

#include <algorithm>
#include <array>

namespace drawing {

namespace {

constexpr std::array sizes{1.0, 0.92, 0.84, 0.76, 0.7};  // of the theme's normal type
constexpr std::size_t indented_to = 2;                   // the column below which stands what is folded
constexpr double spacing = 1.45;                         // of lines, of the type's size
constexpr double free_above = 0.7;                       // lines
constexpr double below_headings = 0.3, above_sums = 0.4; // for rules, of the type's size

/// A name that has the room of the empty cells behind it, too.
bool goes_beyond(const tabular::Row& row, std::size_t column)
{
    return column == 0 && row.cells.size() > 2 && row.cells[1].shown.empty() && row.cells[2].shown.empty();
}

/// So many columns below the others rather than a smaller type.
struct Fold {
    std::size_t n_columns;
    double least_size; ///< of the theme's normal type
};

/// What a cell says; the first column has names.
std::string text_of(const tabular::Row& row, std::size_t column)
{
    const std::string& shown = row.cells[column].shown;
    return column == 0 ? shown : ui::with_minus_signs(shown);
}

struct FormulaRoom {
    ui::TextStyle type;
    double width;
    const ui::Fonts& fonts;
};

/// "a + b x + …", with as many whole terms as there is room for, one at least.
std::string shortened_formula(const std::string& formula, const FormulaRoom& room)
{
    const std::string dots = " + …";
    std::string terms = formula, text = formula;
    while (room.fonts.measure(text, room.type).width > room.width) {
        const std::size_t plus = terms.rfind(" + "), minus = terms.rfind(" − ");
        if (plus == std::string::npos && minus == std::string::npos) break;
        const bool ends_with_plus = minus == std::string::npos || (plus != std::string::npos && plus > minus);
        terms.resize(ends_with_plus ? plus : minus);
        text = terms + dots;
    }
    return text;
}

} // namespace

SheetTable::SheetTable(const TableOfRows& table, const TableRoom& room, const ui::Theme& theme, const ui::Fonts& fonts)
    : room_(room), theme_(theme)
{
    constexpr std::size_t all = 1000, least = 3;
    table_ = table(all);
    choose_type(fonts);
    const double lines_per_row = n_folded_ > 0 ? 2.0 : 1.0;
    const double n_lines = room.height / line_height() - 3.5; // headings, sum, and free above
    const auto most = static_cast<std::size_t>(std::max(n_lines / lines_per_row, static_cast<double>(least)));
    if (table_.rows.size() - table_.n_sums > most) table_ = table(most);
    fit_in_width(fonts);
}

/// The largest type in which nothing is shortened, else the largest that leaves formulas some terms.
void SheetTable::choose_type(const ui::Fonts& fonts)
{
    constexpr double few_terms = 14.0; // wide, of the type's size
    for (const Fold fold : {Fold{0, 0.84}, Fold{1, 0.76}, Fold{room_.folded.size(), 0.76}}) {
        n_folded_ = std::min(fold.n_columns, room_.folded.size());
        for (const double size : sizes) {
            if (size < fold.least_size) break;
            size_ = size * theme_.type().normal;
            lay_out(fonts);
            if (width_ <= room_.width) return;
        }
    }
    for (const double size : sizes) {
        size_ = size * theme_.type().normal;
        lay_out(fonts);
        if (size <= 0.84 && width_per_shortened() >= few_terms * size_) return;
    }
}

/// What the other columns leave, shared by those that may be shortened; as they are laid out now.
double SheetTable::width_per_shortened() const
{
    if (room_.shortened.empty()) return 0.0;
    double left = room_.width - (lefts_.back() + widths_.back());
    for (const std::size_t column : room_.shortened) left += widths_[column];
    return left / static_cast<double>(room_.shortened.size());
}

void SheetTable::fit_in_width(const ui::Fonts& fonts)
{
    lay_out(fonts);
    if (width_ <= room_.width) return;
    shorten_columns(fonts);
    lay_out(fonts);
    for (tabular::Row& row : table_.rows) shorten_below(row, fonts);
    lay_out(fonts);
}

/// The columns that need less than their share leave the rest of it to the next, so the narrowest comes first.
void SheetTable::shorten_columns(const ui::Fonts& fonts)
{
    std::vector<std::size_t> columns = room_.shortened;
    std::ranges::sort(columns, {}, [&](std::size_t column) { return widths_[column]; });
    const ui::TextStyle type = style(false, ui::Anchor::Left);
    double left = width_per_shortened() * static_cast<double>(columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const double share = left / static_cast<double>(columns.size() - i);
        for (tabular::Row& row : table_.rows)
            row.cells[columns[i]].shown = shortened_formula(text_of(row, columns[i]), {type, share, fonts});
        left -= std::min(share, widths_[columns[i]]);
    }
}

/// What is folded below a row: its formula gives way.
void SheetTable::shorten_below(tabular::Row& row, const ui::Fonts& fonts)
{
    const ui::TextStyle type = style(false, ui::Anchor::Left);
    const double below = lefts_[indented_to] + fonts.measure(folded_text(row), type).width;
    if (n_folded_ == 0 || below <= room_.width) return;
    const std::size_t column = *std::ranges::max_element(
        room_.folded, {}, [&](std::size_t i) { return fonts.measure(text_of(row, i), type).width; });
    const double width = fonts.measure(text_of(row, column), type).width - (below - room_.width);
    row.cells[column].shown = shortened_formula(text_of(row, column), {type, width, fonts});
}

bool SheetTable::is_in_line(std::size_t column) const
{
    const auto end = room_.folded.begin() + static_cast<std::ptrdiff_t>(n_folded_);
    return std::find(room_.folded.begin(), end, column) == end;
}

/// "F f = 3 x   ∫ F f dx = 12"; what is an equation already has no heading.
std::string SheetTable::folded_text(const tabular::Row& row) const
{
    std::string text;
    for (std::size_t i = 0; i < n_folded_; ++i) {
        const std::size_t column = room_.folded[i];
        const std::string cell = text_of(row, column);
        if (cell.empty()) continue;
        const bool is_equation = cell.find('=') != std::string::npos;
        text += (text.empty() ? "" : "   ") + (is_equation ? "" : table_.columns[column].heading + " = ") + cell;
    }
    return text;
}

double SheetTable::line_height() const { return spacing * size_; }

std::size_t SheetTable::lines_of(const tabular::Row& row) const { return folded_text(row).empty() ? 1 : 2; }

std::size_t SheetTable::n_lines() const
{
    std::size_t n = 1;
    for (const tabular::Row& row : table_.rows) n += lines_of(row);
    return n;
}

double SheetTable::height() const
{
    return line_height() * (static_cast<double>(n_lines()) + free_above) + (below_headings + above_sums) * size_;
}

ui::TextStyle SheetTable::style(bool is_heading, ui::Anchor anchor) const
{
    ui::TextStyle style = theme_.text(is_heading ? ui::Role::FaintLabel : ui::Role::Label, anchor);
    style.size = size_;
    return style;
}

void SheetTable::lay_out(const ui::Fonts& fonts)
{
    const double gap = 1.1 * size_;
    lefts_.assign(table_.columns.size(), 0.0);
    widths_ = lefts_;
    const ui::TextStyle type = style(false, ui::Anchor::Left);
    double left = 0.0;
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
        double width = fonts.measure(table_.columns[i].label(), type).width;
        for (const tabular::Row& row : table_.rows)
            if (!goes_beyond(row, i)) width = std::max(width, fonts.measure(text_of(row, i), type).width);
        lefts_[i] = left;
        widths_[i] = width;
        if (is_in_line(i)) left += width + gap;
    }
    width_ = left - gap;
    for (const tabular::Row& row : table_.rows)
        if (const std::string below = folded_text(row); !below.empty())
            width_ = std::max(width_, lefts_[indented_to] + fonts.measure(below, type).width);
}

void SheetTable::draw_rule(ui::Painter& painter, ui::Point at) const
{
    ui::Stroke stroke = theme_.stroke(ui::Role::Dimension);
    stroke.width = 0.8;
    painter.line(at, at + ui::Point{width_, 0.0}, stroke);
}

void SheetTable::draw_row(ui::Painter& painter, const tabular::Row& row, ui::Point at, bool is_sum) const
{
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        const std::string text = text_of(row, i);
        if (text.empty() || !is_in_line(i)) continue;
        const bool is_right = alignment(table_, i) == tabular::Alignment::Right;
        ui::TextStyle type = style(false, is_right ? ui::Anchor::TopRight : ui::Anchor::TopLeft);
        if (is_sum) type.weight = ui::Weight::Bold;
        painter.text(at + ui::Point{lefts_[i] + (is_right ? widths_[i] : 0.0), 0.0}, text, type);
    }
    const std::string below = folded_text(row);
    if (!below.empty())
        painter.text(at + ui::Point{lefts_[indented_to], line_height()}, below, style(false, ui::Anchor::TopLeft));
}

void SheetTable::draw(ui::Painter& painter, ui::Point corner) const
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    ui::Point at = corner + ui::Point{0.0, free_above * line_height()};
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
        if (!is_in_line(i)) continue;
        const bool is_right = alignment(table_, i) == tabular::Alignment::Right;
        painter.text(at + ui::Point{lefts_[i] + (is_right ? widths_[i] : 0.0), 0.0}, table_.columns[i].label(),
                     style(true, is_right ? ui::Anchor::TopRight : ui::Anchor::TopLeft));
    }
    at.y += line_height() + below_headings * size_;
    draw_rule(painter, at - ui::Point{0.0, 0.3 * size_});
    for (std::size_t i = 0; i < table_.rows.size(); ++i) {
        const bool is_sum = i + table_.n_sums >= table_.rows.size();
        if (is_sum) at.y += above_sums * size_;
        if (is_sum) draw_rule(painter, at - ui::Point{0.0, 0.3 * size_});
        draw_row(painter, table_.rows[i], at, is_sum);
        at.y += line_height() * static_cast<double>(lines_of(table_.rows[i]));
    }
}

} // namespace drawing
