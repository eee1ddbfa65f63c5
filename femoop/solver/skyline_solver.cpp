#include "femoop/solver/skyline_solver.h"

#include <algorithm>

#include "femoop/solver/index.h"

namespace femoop {

void SkylineSolver::analyse_ordered(Pattern pattern)
{
    const std::size_t n = pattern.n();
    first_.resize(n);
    for (std::size_t i = 0; i < n; ++i) first_[i] = static_cast<std::int32_t>(i);
    for (std::size_t column = n; column-- > 0;)
        for (auto at = static_cast<std::size_t>(pattern.column_start[column]);
             at < static_cast<std::size_t>(pattern.column_start[column + 1]); ++at)
            first_[static_cast<std::size_t>(pattern.rows[at])] = static_cast<std::int32_t>(column);
    start_.assign(1, 0);
    start_.reserve(n + 1);
    for (std::size_t i = 0; i < n; ++i) start_.push_back(start_[i] + i - static_cast<std::size_t>(first_[i]));
    entries_.resize(start_[n]);
    d_.resize(n);
}

void SkylineSolver::load(const SparseMatrix& K)
{
    std::fill(entries_.begin(), entries_.end(), 0.0);
    for (std::int32_t column = 0; column < K.cols(); ++column)
        for (SparseMatrix::InnerIterator entry(K, column); entry; ++entry) {
            const auto row = static_cast<std::size_t>(entry.row());
            if (entry.row() == column) d_[row] = entry.value();
            else entries_[start_[row] + static_cast<std::size_t>(column - first_[row])] = entry.value();
        }
}

/// Makes row i of L from row i of K and the rows before; returns the pivot.
double SkylineSolver::eliminate(std::size_t i)
{
    const std::int32_t first = first_[i];
    double* const row = entries_.data() + start_[i]; // row[j - first] is entry (i, j)
    for (std::int32_t j = first + 1; j < static_cast<std::int32_t>(i); ++j) {
        const auto jj = static_cast<std::size_t>(j);
        const std::int32_t from = std::max(first, first_[jj]);
        const double* const above = entries_.data() + start_[jj];
        row[j - first] -= ConstRow(above + (from - first_[jj]), j - from).dot(ConstRow(row + (from - first), j - from));
    }
    double pivot = d_[i];
    for (std::int32_t j = first; j < static_cast<std::int32_t>(i); ++j) {
        const double g = row[j - first];
        row[j - first] = g / d_[static_cast<std::size_t>(j)];
        pivot -= g * row[j - first];
    }
    return pivot;
}

Pivots SkylineSolver::factorize_ordered(const SparseMatrix& K, Signs signs)
{
    load(K);
    const Eigen::VectorXd reference = references(K, signs);
    Pivots pivots;
    for (std::int32_t i = 0; i < K.cols(); ++i) {
        d_[at(i)] = eliminate(at(i));
        if (!pivots.note(i, d_[at(i)], reference[i], signs)) break;
    }
    return pivots;
}

Eigen::MatrixXd SkylineSolver::solve_ordered(Eigen::MatrixXd B) const
{
    const auto row = [this](std::size_t i) {
        return ConstRow(entries_.data() + start_[i], static_cast<Eigen::Index>(start_[i + 1] - start_[i]));
    };
    for (Eigen::Index column = 0; column < B.cols(); ++column) {
        auto x = B.col(column);
        for (std::size_t i = 0; i < d_.size(); ++i)
            x[static_cast<Eigen::Index>(i)] -= row(i).dot(x.segment(first_[i], row(i).size()));
        x.array() /= ConstRow(d_.data(), x.size()).array();
        for (std::size_t i = d_.size(); i-- > 0;)
            x.segment(first_[i], row(i).size()) -= x[static_cast<Eigen::Index>(i)] * row(i);
    }
    return B;
}

} // namespace femoop
