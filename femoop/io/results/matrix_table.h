#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "femoop/tabular/table.h"

namespace femoop {

/// A matrix with what stands beside its rows and above its columns; round-off beside large numbers reads 0. One of small
/// whole numbers has no decimals.
tabular::Table matrix_table(const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                            const Eigen::MatrixXd& matrix);

} // namespace femoop
