#include "apps/frame/report/pages.h"

#include <algorithm>
#include <memory>
#include <string>

#include "apps/frame/view/sheet/legend.h"
#include "ui/paint/painter.h"

namespace frame {

namespace {

constexpr ui::Size a4{794.0, 1123.0}; // 210 x 297 mm at 96 pixels an inch
constexpr double border = 57.0;       // 15 mm
constexpr double width = a4.width - 2.0 * border;
constexpr double bottom = a4.height - border - 20.0;
constexpr double line = 1.4; // of the type's size
const ui::Color ink = ui::rgb(0x1A1A1A);
const ui::Color faint = ui::rgb(0x777777);

ui::TextStyle style_of(double size, ui::Weight weight = ui::Weight::Regular)
{
    return {.color = ink, .size = size, .weight = weight, .anchor = ui::Anchor::TopLeft};
}

/// Fills page after page from the top.
class PageWriter {
public:
    explicit PageWriter(const ui::Fonts& fonts) : fonts_(fonts) { begin_page(); }

    void operator()(const ReportHeading& heading)
    {
        const double size = heading.level == 1 ? 22.0 : heading.level == 2 ? 17.0 : 13.0;
        const bool is_at_top = y_ == border;
        if (!is_at_top) y_ += 0.9 * size;
        need(line * size + 70.0); // and the beginning of what it stands over
        write(heading.text, style_of(size, ui::Weight::Bold));
        y_ += 0.3 * size;
    }
    void operator()(const ReportText& text)
    {
        write(text.text, style_of(11.0));
        y_ += 5.0;
    }
    void operator()(const ReportFigure& figure)
    {
        const double scale = std::min(1.0, width / figure.picture.size().width);
        const double height = scale * figure.picture.size().height;
        need(height + 24.0);
        placed_.push_back({figure.picture, {border, y_}, scale});
        y_ += height + 4.0;
        ui::TextStyle style = style_of(10.5);
        style.color = faint;
        write(figure.caption, style);
        y_ += 10.0;
    }
    void operator()(const ReportTable& table)
    {
        TableLook look = look_of(table);
        need(3.0 * line * look.size);
        headings(table, look);
        for (const auto& row : table.rows) {
            if (y_ + line * look.size > bottom) {
                end_page();
                begin_page();
                headings(table, look);
            }
            cells(row, table, look, ui::Weight::Regular);
        }
        y_ += 10.0;
    }

    std::vector<ui::PdfPage> pages()
    {
        end_page();
        return std::move(pages_);
    }

private:
    struct TableLook {
        double size = 10.0;
        std::vector<double> widths;
    };

    void begin_page()
    {
        painter_ = std::make_unique<ui::Painter>(a4, fonts_);
        y_ = border;
    }
    void end_page()
    {
        const std::string number = std::to_string(pages_.size() + 1);
        ui::TextStyle style = style_of(9.0);
        style.color = faint;
        style.anchor = ui::Anchor::Top;
        painter_->text({0.5 * a4.width, a4.height - border}, number, style);
        ui::PdfPage page{a4, std::move(placed_)};
        page.pictures.push_back({painter_->picture(), {}, 1.0});
        pages_.push_back(std::move(page));
        placed_.clear();
    }
    void need(double height)
    {
        if (y_ + height <= bottom || y_ == border) return;
        end_page();
        begin_page();
    }

    void write(const std::string& text, const ui::TextStyle& style)
    {
        for (const std::string& words : wrapped(fonts_, text, style, width)) {
            if (y_ + line * style.size > bottom) {
                end_page();
                begin_page();
            }
            painter_->text({border, y_}, words, style);
            y_ += line * style.size;
        }
    }

    // As large as the page allows.
    TableLook look_of(const ReportTable& table) const
    {
        constexpr double gap = 1.4; // of the type's size, between columns
        TableLook look;
        const auto measured = [&](double size) {
            std::vector<double> widths;
            for (std::size_t i = 0; i < table.columns.size(); ++i) {
                double most = width_of(table.columns[i].heading, size, ui::Weight::Bold);
                for (const auto& row : table.rows)
                    most = std::max(most, i < row.size() ? width_of(row[i], size, ui::Weight::Regular) : 0.0);
                widths.push_back(most + gap * size);
            }
            return widths;
        };
        look.widths = measured(look.size);
        double total = 0.0;
        for (const double w : look.widths) total += w;
        if (total <= width) return look;
        look.size *= width / total;
        look.widths = measured(look.size);
        return look;
    }
    double width_of(const std::string& text, double size, ui::Weight weight) const
    {
        return fonts_.measure(text, style_of(size, weight)).width;
    }

    void headings(const ReportTable& table, const TableLook& look)
    {
        std::vector<std::string> words;
        for (const auto& column : table.columns) words.push_back(column.heading);
        cells(words, table, look, ui::Weight::Bold);
        painter_->line({border, y_ - 1.0}, {border + width, y_ - 1.0}, {.color = faint, .width = 0.7});
        y_ += 2.0;
    }
    void cells(const std::vector<std::string>& row, const ReportTable& table, const TableLook& look, ui::Weight weight)
    {
        double x = border;
        for (std::size_t i = 0; i < row.size(); ++i) {
            ui::TextStyle style = style_of(look.size, weight);
            const bool is_number = table.columns.at(i).is_number;
            if (is_number) style.anchor = ui::Anchor::TopRight;
            const double at = is_number ? x + look.widths[i] - 0.7 * look.size : x;
            painter_->text({at, y_}, row[i], style);
            x += look.widths[i];
        }
        y_ += line * look.size;
    }

    const ui::Fonts& fonts_;
    std::unique_ptr<ui::Painter> painter_;
    std::vector<ui::PlacedPicture> placed_;
    std::vector<ui::PdfPage> pages_;
    double y_ = border;
};

} // namespace

std::vector<ui::PdfPage> report_pages(const Report& report, const ui::Fonts& fonts)
{
    PageWriter writer(fonts);
    for (const ReportBlock& block : report.blocks) std::visit(writer, block);
    return writer.pages();
}

} // namespace frame
