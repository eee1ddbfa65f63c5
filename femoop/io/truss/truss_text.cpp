#include "femoop/io/truss/truss_text.h"

#include "femoop/model/quantity/number_text.h"
#include "femoop/tabular/latex.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::truss {

namespace {

constexpr std::size_t equation_indent = 3;

std::string plain_paragraph(const Paragraph& paragraph, const Translator& tr)
{
    switch (paragraph.kind) {
    case ParagraphKind::Title:
        return paragraph.text + "\n" + std::string(tabular::shown_width(paragraph.text), '=') + "\n";
    case ParagraphKind::Heading: return "\n" + paragraph.text + "\n";
    case ParagraphKind::Equation: return std::string(equation_indent, ' ') + paragraph.text + "\n";
    case ParagraphKind::Table: return tabular::plain_text(paragraph.table, {equation_indent, decimal_mark(tr)});
    case ParagraphKind::Sentence: break;
    }
    return paragraph.text + "\n";
}

std::string latex_paragraph(const Paragraph& paragraph)
{
    const std::string text = tabular::latex_text(paragraph.text);
    switch (paragraph.kind) {
    case ParagraphKind::Title: return "\\section*{" + text + "}\n";
    case ParagraphKind::Heading: return "\n\\subsection*{" + text + "}\n";
    case ParagraphKind::Equation: return "\\par\\hspace*{2em}" + text + "\n";
    case ParagraphKind::Table: return "\\begin{center}\n" + tabular::latex(paragraph.table) + "\\end{center}\n";
    case ParagraphKind::Sentence: break;
    }
    return "\n" + text + "\n";
}

} // namespace

std::string plain_text(const Sheet& sheet, const Translator& tr)
{
    std::string text;
    for (const Paragraph& paragraph : sheet) text += plain_paragraph(paragraph, tr);
    return text;
}

std::string latex(const Sheet& sheet)
{
    std::string text;
    for (const Paragraph& paragraph : sheet) text += latex_paragraph(paragraph);
    return text;
}

} // namespace femoop::truss
