#include "femoop/io/results/matrix_table.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numeric>
#include <utility>

#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/tabular/halves.h"
#include "femoop/tabular/latex.h"

namespace femoop {

namespace {

bool is_of_small_whole_numbers(const Eigen::MatrixXd& matrix)
{
    constexpr double most = 1e6;
    return (matrix.array() == matrix.array().round()).all() && (matrix.array().abs() < most).all();
}

tabular::Cell whole_number(double value) { return {value, std::to_string(std::lround(value))}; }

} // namespace

tabular::Table matrix_table(const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                            const Eigen::MatrixXd& matrix, RowUnits units)
{
    std::vector<tabular::Column> headers{""};
    headers.insert(headers.end(), columns.begin(), columns.end());
    tabular::Table table(headers);
    const bool is_whole = is_of_small_whole_numbers(matrix);
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        std::vector<tabular::Cell> row{rows[static_cast<std::size_t>(i)]};
        for (Eigen::Index j = 0; j < matrix.cols(); ++j)
            row.push_back(is_whole ? whole_number(matrix(i, j)) : tabular::Cell(matrix(i, j)));
        table.add_row(std::move(row));
    }
    if (units == RowUnits::Different) return table;
    std::vector<std::size_t> numbers(columns.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{1});
    table.silence_round_off(numbers);
    return table;
}

tabular::Table with_six_digits(tabular::Table table, const Translator& tr)
{
    for (tabular::Row& row : table.rows)
        for (tabular::Cell& cell : row.cells)
            if (cell.number) cell.shown = six_digits(*cell.number, tr);
    return table;
}

tabular::Table with_digits(tabular::Table table, int digits, const Translator& tr)
{
    std::array<char, 40> text{};
    for (tabular::Row& row : table.rows)
        for (tabular::Cell& cell : row.cells) {
            if (!cell.number) continue;
            const double value = *cell.number == 0.0 ? 0.0 : tabular::off_half(*cell.number);
            static_cast<void>(std::snprintf(text.data(), text.size(), "%.*g", digits, value));
            cell.shown = localized(text.data(), tr);
        }
    return table;
}

std::string latex_table(tabular::Table table, const Translator& tr)
{
    return "\\par\\smallskip\\noindent\n" + tabular::latex(with_six_digits(std::move(table), tr));
}

} // namespace femoop
