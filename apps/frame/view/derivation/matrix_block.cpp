#include "apps/frame/view/derivation/matrix_block.h"

#include <algorithm>
#include <numeric>

#include "femoop/io/results/matrix_table.h"
#include "ui/text/number_format.h"

namespace frame {

using femoop::derivation::Notation;
using ui::Anchor;
using ui::Point;
using ui::Role;

namespace {

std::string read_symbol(const std::string& symbol, const ui::Catalogue& tr)
{
    return ui::with_minus_signs(femoop::derivation::with_raised_powers(femoop::derivation::symbol_text(symbol, tr)));
}

} // namespace

MatrixBlock::MatrixBlock(const femoop::derivation::NamedMatrix& matrix, Notation notation, const DerivationLook& look,
                         const ui::Fonts& fonts, double em)
    : symbol_(read_symbol(matrix.symbol, look.tr)), notation_(notation), look_(look), fonts_(fonts), em_(em)
{
    for (const std::string& name : matrix.rows) rows_.push_back(read_symbol(name, look.tr));
    for (const std::string& name : matrix.columns) columns_.push_back(read_symbol(name, look.tr));
    if (columns_.size() == 1 && columns_.front() == symbol_) columns_.front().clear(); // it stands there already
    widths_.assign(columns_.size(), 0.0);
    const auto width = [&](const std::string& text) { return fonts.measure(text, em).width; };
    for (std::size_t j = 0; j < columns_.size(); ++j) widths_[j] = width(columns_[j]);
    ui::NumberFormat format = look.units.format();
    format.digits = femoop::derivation::written_digits(matrix, format.digits);
    const auto units = femoop::derivation::row_units(notation);
    for (const tabular::Row& row : femoop::matrix_table(matrix.rows, matrix.columns, matrix.values, units).rows) {
        std::vector<std::string>& texts = numbers_.emplace_back();
        for (std::size_t j = 0; j < columns_.size(); ++j) {
            const double number = row.cells[j + 1].number.value_or(0.0);
            texts.push_back(ui::with_minus_signs(ui::number_text(number, format)));
            widths_[j] = std::max(widths_[j], width(texts.back()));
        }
    }
}

double MatrixBlock::line() const { return 1.45 * em_; }

ui::TextStyle MatrixBlock::style(Role role, Anchor anchor) const
{
    ui::TextStyle sized = look_.theme.text(role, anchor);
    sized.size = em_;
    return sized;
}

double MatrixBlock::names_width() const
{
    double width = fonts_.measure(symbol_, em_, ui::Weight::Bold).width;
    for (const std::string& name : rows_) width = std::max(width, fonts_.measure(name, em_).width);
    return width + 1.0 * em_;
}

double MatrixBlock::column_left(std::size_t column) const
{
    const double gap = 0.9 * em_;
    return names_width() +
           std::accumulate(widths_.begin(), widths_.begin() + static_cast<std::ptrdiff_t>(column), 0.0) +
           gap * static_cast<double>(column);
}

ui::Size MatrixBlock::size() const
{
    return {column_left(widths_.size()) - 0.1 * em_, line() * static_cast<double>(rows_.size() + 1) + 0.3 * em_};
}

void MatrixBlock::draw_numbers(ui::Painter& painter, Point corner) const
{
    for (std::size_t j = 0; j < columns_.size(); ++j) {
        const double right = corner.x + column_left(j) + widths_[j];
        painter.text({right, corner.y + 0.5 * line()}, columns_[j], style(Role::FaintLabel, Anchor::Right));
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            ui::TextStyle number = style(Role::Label, Anchor::Right);
            const bool is_sum = notation_ == Notation::Sum && i + 1 == rows_.size();
            if (is_sum) number.weight = ui::Weight::Bold;
            if (numbers_[i][j] == "0") number.color = look_.theme[Role::FaintLabel].text;
            painter.text({right, corner.y + (static_cast<double>(i) + 1.5) * line()}, numbers_[i][j], number);
        }
    }
}

void MatrixBlock::draw_brackets(ui::Painter& painter, Point corner) const
{
    const ui::Stroke stroke{.color = look_.theme.stroke(Role::Label).color, .width = std::max(1.0, 0.09 * em_)};
    const double top = corner.y + 1.02 * line(),
                 bottom = corner.y + (static_cast<double>(rows_.size()) + 0.98) * line();
    const double arm = 0.3 * em_, left = corner.x + names_width() - 0.45 * em_,
                 right = corner.x + column_left(widths_.size()) - 0.45 * em_;
    painter.polyline({{left + arm, top}, {left, top}, {left, bottom}, {left + arm, bottom}}, stroke);
    painter.polyline({{right - arm, top}, {right, top}, {right, bottom}, {right - arm, bottom}}, stroke);
}

void MatrixBlock::draw(ui::Painter& painter, Point corner) const
{
    const ui::LayerScope layer(painter, ui::Layer::Labels);
    ui::TextStyle head = style(Role::Label, Anchor::Left);
    head.weight = ui::Weight::Bold;
    painter.text({corner.x, corner.y + 0.5 * line()}, symbol_, head);
    for (std::size_t i = 0; i < rows_.size(); ++i)
        painter.text({corner.x, corner.y + (static_cast<double>(i) + 1.5) * line()}, rows_[i],
                     style(Role::FaintLabel, Anchor::Left));
    draw_numbers(painter, corner);
    if (notation_ == Notation::Matrix) draw_brackets(painter, corner);
    if (notation_ != Notation::Sum) return;
    const double y = corner.y + static_cast<double>(rows_.size()) * line();
    painter.line({corner.x, y}, {corner.x + size().width, y},
                 {.color = look_.theme.stroke(Role::Label).color, .width = std::max(1.0, 0.09 * em_)});
}

} // namespace frame
