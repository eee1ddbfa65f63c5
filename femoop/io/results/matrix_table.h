#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "femoop/model/fault/translator.h"
#include "femoop/tabular/table.h"

namespace femoop {

/// Can the numbers of a matrix be compared with one another?
enum class RowUnits : std::uint8_t {
    Alike,    ///< round-off beside large numbers reads 0
    Different ///< below one another stand a length and a stiffness: none is small beside the other
};

/// A matrix with what stands beside its rows and above its columns. One of small whole numbers has no decimals.
tabular::Table matrix_table(const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                            const Eigen::MatrixXd& matrix, RowUnits units = RowUnits::Alike);

/// The table with its numbers written out, six significant digits each, in the reader's language: for writers that leave
/// numbers with every digit.
tabular::Table with_six_digits(tabular::Table table, const Translator& tr);

/// The same with so many digits.
tabular::Table with_digits(tabular::Table table, int digits, const Translator& tr);

/// A paragraph of a LaTeX document with such a table.
std::string latex_table(tabular::Table table, const Translator& tr);

} // namespace femoop
