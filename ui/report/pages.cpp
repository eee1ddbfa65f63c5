#include "ui/report/pages.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <variant>

#include "ui/paint/painter.h"
#include "ui/paint/wrapped_lines.h"

namespace ui {

namespace {

constexpr Size a4{794.0, 1123.0}; // 210 x 297 mm at 96 pixels an inch
constexpr double border = 57.0;   // 15 mm
constexpr double width = a4.width - 2.0 * border;
constexpr double bottom = a4.height - border - 20.0;
constexpr double line = 1.4; // of the type's size
constexpr double text_size = 11.0;
const Color ink = rgb(0x1A1A1A);
const Color faint = rgb(0x777777);

TextStyle style_of(double size, Weight weight = Weight::Regular)
{
    return {.color = ink, .size = size, .weight = weight, .anchor = Anchor::TopLeft};
}

double size_of(const ReportHeading& heading)
{
    constexpr std::array sizes{22.0, 17.0, 13.0, 11.0};
    return sizes.at(static_cast<std::size_t>(heading.level - 1));
}

/// Fills page after page from the top.
class PageWriter {
public:
    PageWriter(const Report& report, const Fonts& fonts) : report_(report), fonts_(fonts) { begin_page(); }

    std::vector<PdfPage> pages()
    {
        for (std::size_t i = 0; i < report_.blocks.size(); ++i) {
            if (is_heading(i) && !(i > 0 && is_heading(i - 1))) need(height_to_keep_from(i));
            std::visit([this](const auto& block) { put(block); }, report_.blocks[i]);
        }
        return finished();
    }

private:
    struct Page {
        std::unique_ptr<Painter> painter;
        std::vector<PlacedPicture> placed{};
    };
    struct TableLook {
        double size = 10.0;
        std::vector<double> widths{};
        std::vector<tabular::Alignment> alignments{};
    };
    static constexpr double above_text = 0.9, below_heading = 0.3; // of a heading's size
    static constexpr double under_table = 10.0, caption = 24.0;

    bool is_heading(std::size_t block) const { return std::holds_alternative<ReportHeading>(report_.blocks[block]); }

    // Headings that follow one another stay together, and with the beginning of what they stand over.
    double height_to_keep_from(std::size_t block) const
    {
        double height = 0.0;
        for (std::size_t i = block; i < report_.blocks.size(); ++i) {
            height += std::visit([this](const auto& next) { return beginning_of(next); }, report_.blocks[i]);
            if (!is_heading(i)) break;
        }
        return height;
    }
    double beginning_of(const ReportHeading& heading) const
    {
        return (above_text + line + below_heading) * size_of(heading);
    }
    double beginning_of(const ReportText&) const { return 2.0 * line * text_size; }
    double beginning_of(const ReportFigure& figure) const
    {
        return scale_of(figure) * figure.picture.size().height + caption;
    }
    // A short table stands on one page; of a long one some rows come before the first break.
    double beginning_of(const tabular::Table& table) const
    {
        constexpr std::size_t most_whole = 12, rows_kept = 3;
        const std::size_t n_rows = table.rows.size() <= most_whole ? table.rows.size() : rows_kept;
        return static_cast<double>(n_rows + 1) * line * look_of(legible(table).front()).size + 4.0;
    }

    // A table that is too wide for a type that can be read goes on below itself with its further columns; each part
    // begins with the words by which its rows are known.
    std::vector<tabular::Table> legible(const tabular::Table& table) const
    {
        constexpr double least_size = 8.0; // 6 pt
        if (look_of(table).size >= least_size) return {table};
        const std::vector<double> widths = widths_of(table, text_size - 1.0);
        std::size_t n_keys = 1;
        while (n_keys < table.columns.size() && n_keys < 2 && alignment(table, n_keys) == tabular::Alignment::Left)
            ++n_keys;
        std::vector<std::size_t> keys, chosen;
        for (std::size_t i = 0; i < n_keys; ++i) keys.push_back(i);
        std::vector<tabular::Table> parts;
        double taken = 0.0;
        for (std::size_t i = n_keys; i < table.columns.size(); ++i) {
            const bool is_full = !chosen.empty() && taken + widths[i] > width;
            if (is_full) parts.push_back(columns_of(table, std::exchange(chosen, {})));
            if (chosen.empty()) {
                chosen = keys;
                taken = std::accumulate(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(n_keys), 0.0);
            }
            chosen.push_back(i);
            taken += widths[i];
        }
        parts.push_back(columns_of(table, chosen));
        return parts;
    }
    static double scale_of(const ReportFigure& figure) { return std::min(1.0, width / figure.picture.size().width); }

    void put(const ReportHeading& heading)
    {
        const double size = size_of(heading);
        const bool is_at_top = y_ == border;
        if (!is_at_top) y_ += above_text * size;
        write(heading.text, style_of(size, Weight::Bold));
        y_ += below_heading * size;
    }
    void put(const ReportText& text)
    {
        write(text.text, style_of(text_size));
        y_ += 5.0;
    }
    void put(const ReportFigure& figure)
    {
        const double scale = scale_of(figure);
        need(beginning_of(figure));
        pages_.back().placed.push_back({figure.picture, {border, y_}, scale});
        y_ += scale * figure.picture.size().height + 4.0;
        TextStyle style = style_of(10.5);
        style.color = faint;
        write(figure.caption, style);
        y_ += 10.0;
    }
    void put(const tabular::Table& table)
    {
        for (const tabular::Table& part : legible(table)) put_part(part);
    }
    void put_part(const tabular::Table& table)
    {
        const TableLook look = look_of(table);
        need(beginning_of(table));
        headings(table, look);
        for (const auto& row : table.rows) {
            if (y_ + line * look.size > bottom) {
                begin_page();
                headings(table, look);
            }
            cells(shown_texts(row), look, Weight::Regular);
        }
        y_ += under_table;
    }

    void begin_page()
    {
        pages_.push_back({std::make_unique<Painter>(a4, fonts_)});
        y_ = border;
    }
    Painter& painter() { return *pages_.back().painter; }
    void need(double height)
    {
        if (y_ + height > bottom && y_ != border) begin_page();
    }

    // The title and "3 / 12" at the foot of each.
    std::vector<PdfPage> finished()
    {
        std::vector<PdfPage> done;
        for (Page& page : pages_) {
            foot(*page.painter, done.size() + 1);
            done.push_back({a4, std::move(page.placed)});
            done.back().pictures.push_back({page.painter->picture(), {}, 1.0});
        }
        return done;
    }
    void foot(Painter& page, std::size_t number) const
    {
        TextStyle style = style_of(9.0);
        style.color = faint;
        const double y = a4.height - border;
        const std::vector<std::string> title = wrapped_lines(fonts_, report_.title, style, 0.85 * width);
        if (!title.empty()) page.text({border, y}, title.front(), style);
        style.anchor = Anchor::TopRight;
        page.text({a4.width - border, y}, std::to_string(number) + " / " + std::to_string(pages_.size()), style);
    }

    void write(const std::string& text, const TextStyle& style)
    {
        for (const std::string& words : wrapped_lines(fonts_, text, style, width)) {
            if (y_ + line * style.size > bottom) begin_page();
            painter().text({border, y_}, words, style);
            y_ += line * style.size;
        }
    }

    // As large as the page allows.
    TableLook look_of(const tabular::Table& table) const
    {
        TableLook look;
        for (std::size_t i = 0; i < table.columns.size(); ++i) look.alignments.push_back(alignment(table, i));
        look.widths = widths_of(table, look.size);
        const double total = std::accumulate(look.widths.begin(), look.widths.end(), 0.0);
        if (total <= width) return look;
        look.size *= width / total;
        look.widths = widths_of(table, look.size);
        return look;
    }
    std::vector<double> widths_of(const tabular::Table& table, double size) const
    {
        constexpr double gap = 1.4; // of the type's size, between columns
        std::vector<double> widths;
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            double most = width_of(table.columns[i].label(), size, Weight::Bold);
            for (const auto& row : table.rows)
                most = std::max(most, width_of(shown_text(row.cells[i]), size, Weight::Regular));
            widths.push_back(most + gap * size);
        }
        return widths;
    }
    double width_of(const std::string& text, double size, Weight weight) const
    {
        return fonts_.measure(text, style_of(size, weight)).width;
    }

    void headings(const tabular::Table& table, const TableLook& look)
    {
        cells(labels(table), look, Weight::Bold);
        painter().line({border, y_ - 1.0}, {border + width, y_ - 1.0}, {.color = faint, .width = 0.7});
        y_ += 2.0;
    }
    void cells(const std::vector<std::string>& row, const TableLook& look, Weight weight)
    {
        double x = border;
        for (std::size_t i = 0; i < row.size(); ++i) {
            TextStyle style = style_of(look.size, weight);
            const bool is_right = look.alignments.at(i) == tabular::Alignment::Right;
            if (is_right) style.anchor = Anchor::TopRight;
            const double at = is_right ? x + look.widths[i] - 0.7 * look.size : x;
            painter().text({at, y_}, row[i], style);
            x += look.widths[i];
        }
        y_ += line * look.size;
    }

    const Report& report_;
    const Fonts& fonts_;
    std::vector<Page> pages_;
    double y_ = border;
};

} // namespace

std::vector<PdfPage> report_pages(const Report& report, const Fonts& fonts)
{
    return PageWriter(report, fonts).pages();
}

} // namespace ui
