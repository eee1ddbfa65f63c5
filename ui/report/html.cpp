#include "ui/report/html.h"

#include <string_view>

#include "ui/paint/surface/svg.h"

namespace ui {

namespace {

std::string as_html(std::string_view text)
{
    std::string html;
    for (const char c : text) {
        switch (c) {
        case '&': html += "&amp;"; break;
        case '<': html += "&lt;"; break;
        case '>': html += "&gt;"; break;
        case '"': html += "&quot;"; break;
        case '\n': html += "<br>\n"; break;
        default: html += c;
        }
    }
    return html;
}

constexpr std::string_view style = R"(<style>
body { font: 15px/1.45 "DejaVu Sans", sans-serif; color: #1a1a1a; max-width: 46em; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.7em; } h2 { margin-top: 2em; border-bottom: 1px solid #999; } h3 { margin: 1.4em 0 0.4em; }
table { border-collapse: collapse; font-size: 0.87em; margin: 0.4em 0 1em; display: block; overflow-x: auto; }
th, td { padding: 0.2em 0.7em; border-bottom: 1px solid #ddd; text-align: left; white-space: nowrap; }
.n { text-align: right; font-variant-numeric: tabular-nums; }
figure { margin: 1em 0; break-inside: avoid; } figure svg { max-width: 100%; height: auto; }
figcaption { font-size: 0.87em; color: #555; }
@media print { body { margin: 0; max-width: none; font-size: 11px; } h2 { break-before: page; } tr { break-inside: avoid; }
               table { display: table; } h3, h4 { break-after: avoid; } }
</style>
)";

/// The drawing alone, without the XML declaration of a file of its own.
std::string_view without_prolog(std::string_view svg)
{
    const std::size_t begin = svg.find("<svg");
    return begin == std::string_view::npos ? svg : svg.substr(begin);
}

class HtmlWriter {
public:
    explicit HtmlWriter(const Fonts& fonts) : fonts_(fonts) {}

    void operator()(const ReportHeading& heading)
    {
        const std::string tag = "h" + std::to_string(heading.level);
        html += "<" + tag + ">" + as_html(heading.text) + "</" + tag + ">\n";
    }
    void operator()(const ReportText& text) { html += "<p>" + as_html(text.text) + "</p>\n"; }
    void operator()(const ReportTable& table)
    {
        html += "<table>\n<thead><tr>";
        for (const auto& column : table.columns) cell("th", column.is_number, column.heading);
        html += "</tr></thead>\n<tbody>\n";
        for (const auto& row : table.rows) {
            html += "<tr>";
            for (std::size_t i = 0; i < row.size(); ++i) cell("td", table.columns.at(i).is_number, row[i]);
            html += "</tr>\n";
        }
        html += "</tbody>\n</table>\n";
    }
    void operator()(const ReportFigure& figure)
    {
        html += "<figure>\n";
        html += without_prolog(svg_document(figure.picture, fonts_, rgb(0xFFFFFF)));
        if (!figure.caption.empty()) html += "\n<figcaption>" + as_html(figure.caption) + "</figcaption>";
        html += "\n</figure>\n";
    }

    std::string html;

private:
    void cell(std::string_view tag, bool is_number, std::string_view text)
    {
        html += "<" + std::string(tag) + (is_number ? " class=\"n\">" : ">") + as_html(text) + "</" + std::string(tag) +
                ">";
    }

    const Fonts& fonts_;
};

} // namespace

std::string report_html(const Report& report, const Fonts& fonts)
{
    HtmlWriter writer(fonts);
    writer.html = "<!DOCTYPE html>\n<html lang=\"" + report.language +
                  "\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + as_html(report.title) + "</title>\n" +
                  std::string(style) + "</head>\n<body>\n";
    for (const ReportBlock& block : report.blocks) std::visit(writer, block);
    return writer.html + "</body>\n</html>\n";
}

} // namespace ui
