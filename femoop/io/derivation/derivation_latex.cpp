#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "femoop/io/derivation/derivation_text.h"
#include "femoop/io/results/matrix_table.h"
#include "femoop/model/fault/fault.h"
#include "femoop/tabular/latex.h"

namespace femoop::derivation {

namespace {

constexpr std::size_t names_width = 8;    ///< in letters
constexpr Eigen::Index most_columns = 13; ///< of a matrix on a page; a wider one stands transposed

/// Of the symbols that are no names: f_0' for f0'.
std::string formula(const std::string& symbol)
{
    using Formula = std::pair<std::string_view, std::string_view>;
    constexpr auto formulas = std::to_array<Formula>({{"k'", "k'"},
                                                      {"T", "T"},
                                                      {"k", "k"},
                                                      {"K", "K"},
                                                      {"f0'", "f_0'"},
                                                      {"f0", "f_0"},
                                                      {"f", "f"},
                                                      {"u", "u"},
                                                      {"u'", "u'"},
                                                      {"C", "C"},
                                                      {"G", "G"},
                                                      {"c", "c"},
                                                      {"y", "y"},
                                                      {"u0", "u_0"},
                                                      {"X", "X"},
                                                      {"c - δ0", "c - \\delta_0"},
                                                      {"δ", "\\delta"}});
    const auto* const found = std::ranges::find(formulas, symbol, &Formula::first);
    return found == formulas.end() ? std::string() : std::string(found->second);
}

/// The numbers of a matrix as they are shown.
class MatrixLatex {
public:
    MatrixLatex(const Step& step, const NamedMatrix& matrix, const Translator& tr)
        : step_(step),
          matrix_(matrix),
          tr_(tr),
          table_(with_digits(
              matrix_table(matrix.rows, matrix.columns, matrix.values, row_units(notation_of(step, matrix))),
              written_digits(matrix), tr))
    {}

    /// One column bears its name, or the matrix'; more stand beside that.
    std::string named_numbers() const
    {
        tabular::Table table = table_;
        const bool is_named = matrix_.columns.size() == 1 && !matrix_.columns[0].empty();
        for (std::size_t j = 0; j < matrix_.columns.size(); ++j)
            table.columns[j + 1].heading = read(matrix_.columns[j]);
        if (!is_named) table.columns.front().heading = read(matrix_.symbol);
        for (std::size_t i = 0; i < table.rows.size(); ++i) table.rows[i].cells.front() = read(matrix_.rows[i]);
        if (notation_of(step_, matrix_) == Notation::Sum) table.n_sums = 1;
        return latex_table(std::move(table), tr_);
    }

    bool is_transposed() const { return matrix_.values.cols() > most_columns; }
    std::string symbol() const
    {
        const std::string known = formula(matrix_.symbol);
        return (known.empty() ? name(matrix_.symbol) : known) + (is_transposed() ? "^{\\mathsf T}" : "");
    }

    /// In brackets, the names of its rows beside it.
    std::string bracketed(bool has_names = true) const
    {
        std::string text = "\\begin{bmatrix}\n", names = "\\begin{matrix}\n";
        const Eigen::Index n = is_transposed() ? matrix_.values.cols() : matrix_.values.rows();
        const Eigen::Index m = is_transposed() ? matrix_.values.rows() : matrix_.values.cols();
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index j = 0; j < m; ++j)
                text += (j == 0 ? "" : " & ") + (is_transposed() ? entry(j, i) : entry(i, j));
            text += " \\\\\n";
            names += name(beside()[static_cast<std::size_t>(i)]) + " \\\\\n";
        }
        text += "\\end{bmatrix}\n";
        return has_names ? text + names + "\\end{matrix}\n" : text;
    }

    /// Of the columns, where they are not those of the rows.
    std::string column_names() const
    {
        const std::vector<std::string>& names = is_transposed() ? matrix_.rows : matrix_.columns;
        if (names == beside() || names.size() < 2) return {};
        std::string list;
        for (const std::string& one : names) list += (list.empty() ? "" : ", ") + read(one);
        return "\\noindent " + tabular::latex_text(fill(tr_("Columns of {0}: {1}."), {matrix_.symbol, list})) + "\n";
    }

    /// Of the numbers of a row, the longest of each column, in letters.
    std::size_t width() const
    {
        std::size_t sum = 0;
        for (std::size_t j = 1; j < table_.columns.size(); ++j) {
            std::size_t longest = 0;
            for (const tabular::Row& row : table_.rows) longest = std::max(longest, row.cells[j].shown.size());
            sum += longest + 1;
        }
        return is_transposed() ? 0 : sum;
    }

private:
    const std::vector<std::string>& beside() const { return is_transposed() ? matrix_.columns : matrix_.rows; }
    std::string read(const std::string& symbol) const { return with_raised_powers(symbol_text(symbol, tr_)); }
    std::string name(const std::string& symbol) const { return "\\text{" + tabular::latex_text(read(symbol)) + "}"; }
    std::string entry(Eigen::Index i, Eigen::Index j) const
    {
        const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(j);
        const std::string number = tabular::latex_formula(table_.rows[row].cells[column + 1].shown);
        return is_lit(step_, matrix_, row, column) && number != "0" ? "\\mathbf{" + number + "}" : number;
    }

    const Step& step_;
    const NamedMatrix& matrix_;
    const Translator& tr_;
    tabular::Table table_;
};

std::string displayed(const std::string& formula, std::size_t width, Eigen::Index n_columns)
{
    const std::string_view size = width > 85 ? "\\tiny" : width > 70 ? "\\scriptsize" : width > 52 ? "\\small" : "";
    return "{" + std::string(size) + "\\setlength{\\arraycolsep}{3pt}" +
           (n_columns > 10 ? "\\setcounter{MaxMatrixCols}{" + std::to_string(n_columns) + "}" : "") + "\n\\[\n" +
           formula + "\\]}\n";
}

/// K u = f in one line where it is short, else one below the other.
std::string equations_latex(const Step& step, const Translator& tr)
{
    const std::vector<NamedMatrix>& all = step.matrices;
    const std::array matrices{MatrixLatex(step, all[0], tr), MatrixLatex(step, all[1], tr),
                              MatrixLatex(step, all[2], tr)};
    std::string text;
    if (matrices[0].is_transposed()) {
        for (const MatrixLatex& one : matrices)
            text += displayed(one.symbol() + " = " + one.bracketed(), one.width(), 0) + one.column_names();
        return text;
    }
    const bool is_square = all[0].rows == all[0].columns; // then the names stand beside f alone
    const std::size_t width = matrices[0].width() + matrices[1].width() + matrices[2].width() + names_width;
    return displayed(matrices[0].bracketed(false) + matrices[1].bracketed(!is_square) + " = " + matrices[2].bracketed(),
                     width, all[0].values.cols()) +
           matrices[0].column_names();
}

std::string matrix_latex(const Step& step, const NamedMatrix& matrix, const Translator& tr)
{
    const MatrixLatex latex(step, matrix, tr);
    if (notation_of(step, matrix) != Notation::Matrix) return latex.named_numbers();
    return displayed(latex.symbol() + " = " + latex.bracketed(), latex.width() + names_width, matrix.values.cols()) +
           latex.column_names();
}

/// Two columns stand side by side: f0' and f0, u and u'.
std::string pair_latex(const Step& step, const Translator& tr)
{
    const MatrixLatex first(step, step.matrices[0], tr), second(step, step.matrices[1], tr);
    return displayed(
        first.symbol() + " = " + first.bracketed() + "\\qquad\n" + second.symbol() + " = " + second.bracketed(), 0, 1);
}

bool is_pair_of_columns(const Step& step)
{
    return step.matrices.size() == 2 && std::ranges::all_of(step.matrices, [&](const NamedMatrix& one) {
               return notation_of(step, one) == Notation::Matrix && one.columns.size() == 1;
           });
}

std::string step_latex(const Step& step, const Translator& tr)
{
    if (is_system(step)) return equations_latex(step, tr);
    if (is_pair_of_columns(step)) return pair_latex(step, tr);
    std::string text;
    for (const NamedMatrix& matrix : step.matrices) text += matrix_latex(step, matrix, tr);
    return text;
}

} // namespace

std::string derivation_latex(const Derivation& derivation, const Model& model, const Translator& tr)
{
    std::string text = "% \\usepackage{amsmath}\n\\section*{" +
                       tabular::latex_text(derivation_title(derivation, model, tr)) + "}\n" +
                       tabular::latex_text(derivation_units(model, tr)) + "\n";
    for (std::size_t i = 0; i < derivation.steps.size(); ++i) {
        const Step& step = derivation.steps[i];
        text += "\n\\paragraph{" + std::to_string(i + 1) + ".}\n";
        if (step.load_case) text += tabular::latex_text(model.case_name(*step.load_case)) + ": ";
        text += tabular::latex_text(with_raised_powers(sentence(step, model, tr))) + "\n" + step_latex(step, tr);
    }
    const std::string closing = closing_text(derivation, tr);
    return closing.empty() ? text : text + "\n\\par\n" + tabular::latex_text(closing) + "\n";
}

} // namespace femoop::derivation
