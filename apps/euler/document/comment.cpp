#include "apps/euler/document/comment.h"

#include "topology/text/words.h"
#include "ui/text/trimmed.h"

namespace euler {

namespace {

constexpr std::string_view display = "    "; // so deep a line shows a command and is no part of a sentence

/// What follows the # that begins a comment; "" where there is none.
std::string after_mark(std::string_view line)
{
    for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
        if (at == 0 || line[at - 1] == ' ' || line[at - 1] == '\t')
            return line.substr(at + 1).starts_with(display) ? "" : std::string(ui::trimmed(line.substr(at + 1)));
    return "";
}

void append(std::string& paragraph, const std::string& text)
{
    if (!paragraph.empty() && !text.empty()) paragraph += ' ';
    paragraph += text;
}

bool is_blank(std::string_view line) { return ui::trimmed(line).empty(); }

} // namespace

std::string comment(std::string_view above, std::string_view line)
{
    std::string paragraph;
    for (topology::Lines lines(above); lines.next();) {
        if (is_blank(lines.line())) paragraph.clear();
        append(paragraph, after_mark(lines.line()));
    }
    append(paragraph, after_mark(line));
    return paragraph;
}

std::string first_comment(std::string_view text)
{
    std::string paragraph;
    for (topology::Lines lines(text); lines.next() && ui::trimmed(lines.line()).starts_with('#');)
        append(paragraph, after_mark(lines.line()));
    return paragraph;
}

} // namespace euler
