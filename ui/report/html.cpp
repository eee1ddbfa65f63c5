#include "ui/report/html.h"

#include <string_view>

#include "femoop/tabular/html.h"
#include "ui/paint/surface/svg.h"

namespace ui {

namespace {

constexpr std::string_view style = R"(<style>
body { font: 15px/1.45 "DejaVu Sans", sans-serif; color: #1a1a1a; max-width: 46em; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.7em; } h2 { margin-top: 2em; border-bottom: 1px solid #999; } h3 { margin: 1.4em 0 0.4em; }
table { border-collapse: collapse; font-size: 0.87em; margin: 0.4em 0 1em; display: block; overflow-x: auto; }
th, td { padding: 0.2em 0.7em; border-bottom: 1px solid #ddd; text-align: left; white-space: nowrap; }
.n { text-align: right; font-variant-numeric: tabular-nums; }
figure { margin: 1em 0; break-inside: avoid; } figure svg { max-width: 100%; height: auto; }
figcaption { font-size: 0.87em; color: #555; }
@media print { body { margin: 0; max-width: none; font-size: 11px; } h2 ~ h2 { break-before: page; }
               tr { break-inside: avoid; } table { display: table; } h3, h4 { break-after: avoid; } }
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
        html += "<" + tag + ">" + tabular::html_text(heading.text) + "</" + tag + ">\n";
    }
    void operator()(const ReportText& text) { html += "<p>" + tabular::html_text(text.text) + "</p>\n"; }
    void operator()(const tabular::Table& table) { html += tabular::html(table); }
    void operator()(const ReportFigure& figure)
    {
        html += "<figure>\n";
        html += without_prolog(svg_document(figure.picture, fonts_, rgb(0xFFFFFF)));
        if (!figure.caption.empty()) html += "\n<figcaption>" + tabular::html_text(figure.caption) + "</figcaption>";
        html += "\n</figure>\n";
    }

    std::string html;

private:
    const Fonts& fonts_;
};

} // namespace

std::string report_html(const Report& report, const Fonts& fonts)
{
    HtmlWriter writer(fonts);
    writer.html = "<!DOCTYPE html>\n<html lang=\"" + report.language +
                  "\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + tabular::html_text(report.title) + "</title>\n" +
                  std::string(style) + "</head>\n<body>\n";
    for (const ReportBlock& block : report.blocks) std::visit(writer, block);
    return writer.html + "</body>\n</html>\n";
}

} // namespace ui
