#include <cstddef>
#include <utility>
#include <vector>

#include "femoop/io/derivation/derivation_text.h"
#include "femoop/io/results/matrix_table.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/tabular/latex.h"

namespace femoop::derivation {

namespace {

/// One column bears its name, or the matrix'; more stand beside that.
std::string matrix_latex(const NamedMatrix& matrix, const Translator& tr)
{
    tabular::Table table = matrix_table(matrix.rows, matrix.columns, matrix.values);
    for (tabular::Row& row : table.rows)
        for (tabular::Cell& cell : row.cells)
            if (cell.number) cell.shown = six_digits(*cell.number, tr);
    const bool is_named = matrix.columns.size() == 1 && !matrix.columns[0].empty();
    if (!is_named) table.columns.front().heading = matrix.symbol;
    return tabular::latex(table);
}

} // namespace

std::string derivation_latex(const Derivation& derivation, const Model& model, const Translator& tr)
{
    std::string text = "\\section*{" + tabular::latex_text(derivation_title(derivation, model, tr)) + "}\n" +
                       tabular::latex_text(derivation_units(model, tr)) + "\n";
    for (std::size_t i = 0; i < derivation.steps.size(); ++i) {
        const Step& step = derivation.steps[i];
        text += "\n\\paragraph{" + std::to_string(i + 1) + ".}\n";
        if (step.load_case) text += tabular::latex_text(model.case_name(*step.load_case)) + ": ";
        text += tabular::latex_text(sentence(step, model, tr)) + "\n";
        for (const NamedMatrix& matrix : step.matrices)
            text += "\\par\\smallskip\\noindent\n" + matrix_latex(matrix, tr);
    }
    return text;
}

} // namespace femoop::derivation
