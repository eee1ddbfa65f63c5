#include "femoop/tabular/markdown.h"

namespace tabular {

std::string markdown_text(std::string_view text)
{
    constexpr std::string_view special = "\\|`*_[]<>~&#$";
    std::string markdown;
    for (const char c : text) {
        if (special.find(c) != std::string_view::npos) markdown += '\\';
        if (c == '\n') markdown += "<br>";
        else markdown += c;
    }
    return markdown;
}

std::string markdown(const Table& table)
{
    std::string text = table.title.empty() ? "" : "### " + markdown_text(table.title) + "\n\n";
    for (const std::string& note : table.notes) text += markdown_text(note) + "\n\n";
    if (table.columns.empty()) return text;
    std::string rule;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        text += "| " + markdown_text(table.columns[i].label()) + " ";
        rule += alignment(table, i) == Alignment::Right ? "|---:" : "|---";
    }
    text += "|\n" + rule + "|\n";
    for (const Row& row : table.rows) {
        for (const Cell& cell : row.cells) text += "| " + markdown_text(shown_text(cell)) + " ";
        text += "|\n";
    }
    return text;
}

} // namespace tabular
