#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "femoop/model/ids.h"

namespace femoop {

/// One linear equation between unknowns that a constraint imposes: sum of coefficient x unknown = value, per load case.
struct ConstraintRow {
    struct Term {
        std::int32_t unknown;
        double coefficient;
    };
    std::vector<Term> terms; ///< ascending unknowns
    Eigen::VectorXd value;   ///< [load cases]: imposed strains and settlements
    MemberId member;
};

/// What constraints leave free: every unknown as x = T y + x0 of the independent ones y.
///
/// Exact elimination with pivoting, no penalty number. Rows that say what others have said already are dropped, if
/// they say it with the same value.
struct Elimination {
    Eigen::SparseMatrix<double> T;       ///< [unknowns x independent]
    Eigen::MatrixXd x0;                  ///< [unknowns x load cases]
    std::vector<std::int32_t> dependent; ///< unknowns that were eliminated, one per independent row

    /// A row that contradicts others: which members together, in which load case.
    struct Conflict {
        std::size_t load_case;
        std::vector<MemberId> members;
    };
    std::vector<Conflict> conflicts;
};

/// `scale` makes translations and rotations comparable: the largest coefficient x scale is the pivot.
Elimination eliminate(const std::vector<ConstraintRow>& rows, std::size_t n_unknowns, std::size_t n_cases,
                      const Eigen::VectorXd& scale);

} // namespace femoop
