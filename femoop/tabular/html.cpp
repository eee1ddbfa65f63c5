#include "femoop/tabular/html.h"

namespace tabular {

namespace {

std::string html_cell(std::string_view tag, Alignment at, std::string_view text)
{
    const std::string name(tag);
    return "<" + name + (at == Alignment::Right ? " class=\"n\">" : ">") + html_text(text) + "</" + name + ">";
}

} // namespace

std::string html_text(std::string_view text)
{
    std::string html;
    for (const char c : text) {
        switch (c) {
        case '&': html += "&amp;"; break;
        case '<': html += "&lt;"; break;
        case '>': html += "&gt;"; break;
        case '"': html += "&quot;"; break;
        case '\'': html += "&#39;"; break;
        case '\n': html += "<br>\n"; break;
        default: html += c;
        }
    }
    return html;
}

std::string html(const Table& table)
{
    std::vector<Alignment> alignments;
    for (std::size_t i = 0; i < table.columns.size(); ++i) alignments.push_back(alignment(table, i));
    std::string html = "<table>\n<thead><tr>";
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        html += html_cell("th", alignments[i], table.columns[i].label());
    html += "</tr></thead>\n<tbody>\n";
    for (const Row& row : table.rows) {
        html += "<tr>";
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            html += html_cell("td", alignments[i], shown_text(row.cells[i]));
        html += "</tr>\n";
    }
    return html + "</tbody>\n</table>\n";
}

} // namespace tabular
