#include "apps/frame/view/derivation/matrix_block.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "femoop/io/results/matrix_table.h"
#include "ui/text/language_manner.h"
#include "ui/text/number_format.h"

namespace frame {

using ui::Anchor;
using ui::Point;
using ui::Role;
using ui::translatable;

namespace {

void replace_all(std::string& text, std::string_view what, std::string_view by)
{
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
}

/// M(BC, 2,25): what stands behind the comma is a number.
void localize_place(std::string& text, const ui::Catalogue& tr)
{
    const std::size_t place = text.rfind(", ");
    const std::size_t point = place == std::string::npos ? place : text.find('.', place);
    if (point != std::string::npos && ui::decimal_mark(tr.language()) == ui::DecimalMark::Comma) text[point] = ',';
}

constexpr std::array words{translatable("data"),       translatable("entries"), translatable("place"),
                           translatable("factors"),    translatable("factor"),  translatable("value"),
                           translatable("extremes"),   translatable("max"),     translatable("min"),
                           translatable("foundation"), translatable("spring"),  translatable("p at the node"),
                           translatable("sum")};

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

std::string lowered(char digit)
{
    static constexpr std::array<std::string_view, 10> digits{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    return std::string(digits.at(static_cast<std::size_t>(digit - '0')));
}

} // namespace

std::string with_deltas(const std::string& text)
{
    constexpr std::string_view name = "delta";
    std::string written;
    for (std::size_t at = 0; at < text.size();) {
        if (text.compare(at, name.size(), name) != 0) {
            written += text[at++];
            continue;
        }
        written += "δ";
        at += name.size();
        const bool has_index = at + 1 < text.size() && text[at] == '_' && is_digit(text[at + 1]);
        if (has_index) ++at;
        while (has_index && at < text.size() && is_digit(text[at])) written += lowered(text[at++]);
    }
    return written;
}

std::string with_raised_powers(std::string text)
{
    replace_all(text, "^2", "²");
    replace_all(text, "^3", "³");
    replace_all(text, "^T", "ᵀ");
    return text;
}

std::string symbol_text(const std::string& symbol, const ui::Catalogue& tr)
{
    if (std::ranges::find(words, symbol) != words.end()) return tr(symbol);
    std::string text = with_raised_powers(symbol);
    localize_place(text, tr);
    return ui::with_minus_signs(text);
}

MatrixBlock::MatrixBlock(const femoop::derivation::NamedMatrix& matrix, Kind kind, const DerivationLook& look,
                         const ui::Fonts& fonts, double em)
    : symbol_(with_deltas(symbol_text(matrix.symbol, look.tr))), kind_(kind), look_(look), fonts_(fonts), em_(em)
{
    for (const std::string& name : matrix.rows) rows_.push_back(symbol_text(name, look.tr));
    for (const std::string& name : matrix.columns) columns_.push_back(with_deltas(symbol_text(name, look.tr)));
    if (columns_.size() == 1 && columns_.front() == symbol_) columns_.front().clear(); // it stands there already
    widths_.assign(columns_.size(), 0.0);
    const auto width = [&](const std::string& text) { return fonts.measure(text, em).width; };
    for (std::size_t j = 0; j < columns_.size(); ++j) widths_[j] = width(columns_[j]);
    for (const tabular::Row& row : femoop::matrix_table(matrix.rows, matrix.columns, matrix.values).rows) {
        std::vector<std::string>& texts = numbers_.emplace_back();
        for (std::size_t j = 0; j < columns_.size(); ++j) {
            const double number = row.cells[j + 1].number.value_or(0.0);
            texts.push_back(ui::with_minus_signs(ui::number_text(number, look.units.format())));
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
            const bool is_sum = kind_ == Kind::Sum && i + 1 == rows_.size();
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
    if (kind_ == Kind::Matrix) draw_brackets(painter, corner);
    if (kind_ != Kind::Sum) return;
    const double y = corner.y + static_cast<double>(rows_.size()) * line();
    painter.line({corner.x, y}, {corner.x + size().width, y},
                 {.color = look_.theme.stroke(Role::Label).color, .width = std::max(1.0, 0.09 * em_)});
}

} // namespace frame
