#include "femoop/io/results/matrix_table.h"

#include <cstddef>
#include <numeric>
#include <utility>

namespace femoop {

tabular::Table matrix_table(const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                            const Eigen::MatrixXd& matrix)
{
    std::vector<tabular::Column> headers{""};
    headers.insert(headers.end(), columns.begin(), columns.end());
    tabular::Table table(headers);
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        std::vector<tabular::Cell> row{rows[static_cast<std::size_t>(i)]};
        for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.emplace_back(matrix(i, j));
        table.add_row(std::move(row));
    }
    std::vector<std::size_t> numbers(columns.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{1});
    table.silence_round_off(numbers);
    return table;
}

} // namespace femoop
