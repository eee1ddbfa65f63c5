#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "femoop/model/fault/translator.h"
#include "femoop/tabular/table.h"

namespace femoop {

/// A matrix with what stands beside its rows and above its columns; round-off beside large numbers reads 0. One of small
/// whole numbers has no decimals.
tabular::Table matrix_table(const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                            const Eigen::MatrixXd& matrix);

/// The table with its numbers written out, six significant digits each, in the reader's language: for writers that leave
/// numbers with every digit.
tabular::Table with_six_digits(tabular::Table table, const Translator& tr);

/// The same with so many digits.
tabular::Table with_digits(tabular::Table table, int digits, const Translator& tr);

/// A paragraph of a LaTeX document with such a table.
std::string latex_table(tabular::Table table, const Translator& tr);

} // namespace femoop
