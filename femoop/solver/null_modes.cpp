#include "femoop/solver/null_modes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "femoop/algebra/symmetric_eigen.h"

namespace femoop {

namespace {

constexpr double least_shift = 1e-14; // keeps the factorization of a singular matrix alive
constexpr double largest_block = 5e7; // entries of a block of vectors

/// 1 / sqrt(K_ii), bounded where K_ii is nothing.
Eigen::VectorXd unit_diagonal_scale(const SparseMatrix& K)
{
    const Eigen::VectorXd diagonal = K.diagonal();
    const double largest = diagonal.maxCoeff();
    if (!(largest > 0.0)) return Eigen::VectorXd::Ones(K.cols());
    return diagonal.cwiseMax(idle_diagonal * largest).cwiseSqrt().cwiseInverse();
}

/// The sum of absolute values in the worst column: no eigenvalue is larger.
double norm_1(const SparseMatrix& K)
{
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(K.cols());
    for (Eigen::Index column = 0; column < K.cols(); ++column)
        for (SparseMatrix::InnerIterator entry(K, column); entry; ++entry) {
            sums[column] += std::abs(entry.value());
            if (entry.row() != column) sums[entry.row()] += std::abs(entry.value());
        }
    return sums.maxCoeff();
}

/// Factors K + shift I with the least shift that keeps it positive definite.
std::unique_ptr<SymmetricSolver> shifted_inverse(const SparseMatrix& K)
{
    SparseMatrix identity(K.rows(), K.cols());
    identity.setIdentity();
    double shift = least_shift;
    SparseMatrix shifted = K + shift * identity;
    std::unique_ptr<SymmetricSolver> solver = solver_for(shifted);
    while (!solver->factorize(shifted).is_positive_definite) {
        shift *= 10.0;
        shifted = K + shift * identity;
    }
    return solver;
}

/// Makes the columns orthonormal.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns)
{
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
    return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), columns.cols());
}

/// The softest motions of a scaled matrix: Ritz vectors of a block under inverse iteration.
class SoftMotions {
public:
    SoftMotions(const SparseMatrix& K, double zero_tolerance, Eigen::Index most)
        : K_(K),
          zero_(zero_tolerance),
          inverse_(shifted_inverse(K)),
          widest_(std::clamp<Eigen::Index>(static_cast<Eigen::Index>(largest_block) / K.rows(), 16, K.rows()))
    {
        widest_ = std::min({widest_, K.rows(), most + 1});
        for (Eigen::Index width = std::min<Eigen::Index>(8, widest_);; width = std::min(2 * width, widest_)) {
            widen(width);
            iterate();
            if (n_zeros() < width || width == widest_) return;
        }
    }

    const Eigen::MatrixXd& vectors() const { return vectors_; }
    const Eigen::VectorXd& values() const { return values_; }
    const SymmetricSolver& inverse() const { return *inverse_; }
    Eigen::Index n_zeros() const { return (values_.array() <= zero_).count(); }

private:
    void widen(Eigen::Index width)
    {
        std::uniform_real_distribution<double> uniform(-1.0, 1.0);
        const Eigen::Index had = vectors_.cols();
        vectors_.conservativeResize(K_.rows(), width);
        vectors_.rightCols(width - had) = Eigen::MatrixXd::NullaryExpr(K_.rows(), width - had,
                                                                       [&] { return uniform(random_); });
    }

    /// Until the count of zeros and the first value above them stand still.
    void iterate()
    {
        constexpr int most_passes = 40;
        constexpr double settled = 0.01;
        std::pair<Eigen::Index, double> before{-1, 0.0};
        for (int pass = 0; pass < most_passes; ++pass) {
            improve();
            const Eigen::Index zeros = n_zeros();
            if (zeros == values_.size()) return; // a wider block is needed anyway
            const double above = values_[zeros];
            if (zeros == before.first && std::abs(above - before.second) <= settled * above) return;
            before = {zeros, above};
        }
    }

    void improve()
    {
        const Eigen::MatrixXd space = orthonormal(inverse_->solve(vectors_));
        const Eigen::MatrixXd image = K_.selfadjointView<Eigen::Lower>() * space;
        const SymmetricEigen ritz = symmetric_eigen(space.transpose() * image);
        values_ = ritz.values;
        vectors_ = space * ritz.vectors;
    }

    const SparseMatrix& K_;
    double zero_;
    std::unique_ptr<SymmetricSolver> inverse_;
    Eigen::Index widest_;
    std::mt19937 random_{20021}; // fixed: the same structure gives the same answer
    Eigen::MatrixXd vectors_;
    Eigen::VectorXd values_;
};

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Columns of like size: K = A' A then has a unit diagonal, but for columns that are rounding alone.
struct Balanced {
    RowMatrix A;
    Eigen::VectorXd scale; ///< of each column
};

Balanced balanced(const RowMatrix& A, double largest_entry)
{
    constexpr double rounding = 1e-8;
    Eigen::VectorXd sizes = Eigen::VectorXd::Zero(A.cols());
    for (Eigen::Index row = 0; row < A.rows(); ++row)
        for (RowMatrix::InnerIterator entry(A, row); entry; ++entry)
            sizes[entry.col()] = std::hypot(sizes[entry.col()], entry.value());
    const double least = rounding * std::max(largest_entry, sizes.maxCoeff());
    const Eigen::VectorXd scale = least > 0.0 ? Eigen::VectorXd(sizes.cwiseMax(least).cwiseInverse())
                                              : Eigen::VectorXd::Ones(A.cols());
    return {.A = A * scale.asDiagonal(), .scale = scale};
}

/// Takes from soft motions what stiffer ones rounding has left in them.
Eigen::MatrixXd corrected(const RowMatrix& A, const SymmetricSolver& inverse, Eigen::MatrixXd motions)
{
    constexpr int passes = 3;
    constexpr double rounding = 1e-15;
    for (int pass = 0; pass < passes && motions.cols() > 0; ++pass) {
        const Eigen::MatrixXd strains = A * motions;
        if (strains.lpNorm<Eigen::Infinity>() <= rounding) break;
        motions = orthonormal(motions - inverse.solve(A.transpose() * strains));
    }
    return motions;
}

/// Combinations of motions by how little they strain, one column each.
Eigen::MatrixXd by_strain(const RowMatrix& A, const Eigen::MatrixXd& motions)
{
    if (motions.cols() == 0) return motions;
    Eigen::MatrixXd strains = A * motions;
    const Eigen::Index n = strains.cols();
    if (strains.rows() < n) strains.conservativeResizeLike(Eigen::MatrixXd::Zero(n, n));
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(strains);
    const Eigen::MatrixXd R = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(R, Eigen::ComputeFullV);
    return motions * svd.matrixV();
}

/// Row and column of the largest entry at or right of a column; of nearly equal ones the first.
std::pair<Eigen::Index, Eigen::Index> pivot(const Eigen::MatrixXd& modes, Eigen::Index from)
{
    std::pair<Eigen::Index, Eigen::Index> place{0, from};
    double largest = 0.0;
    for (Eigen::Index i = 0; i < modes.rows(); ++i)
        for (Eigen::Index j = from; j < modes.cols(); ++j)
            if (std::abs(modes(i, j)) > largest * (1.0 + 1e-6)) {
                largest = std::abs(modes(i, j));
                place = {i, j};
            }
    return place;
}

/// Reduced echelon form with complete pivoting: each column gets an entry that is zero in all others.
void separate(Eigen::MatrixXd& modes)
{
    for (Eigen::Index mode = 0; mode < modes.cols(); ++mode) {
        const auto [row, column] = pivot(modes, mode);
        modes.col(mode).swap(modes.col(column));
        modes.col(mode) /= modes(row, mode);
        for (Eigen::Index other = 0; other < modes.cols(); ++other)
            if (other != mode) modes.col(other) -= (modes(row, other) * modes.col(mode)).eval();
    }
    constexpr double rounding = 1e-9;
    for (auto mode : modes.colwise()) {
        const double least = rounding * mode.cwiseAbs().maxCoeff();
        mode = mode.unaryExpr([&](double x) { return std::abs(x) < least ? 0.0 : x; });
    }
}

/// Back from the scaled unknowns, the largest entry 1.
Eigen::VectorXd motion(const Eigen::VectorXd& scale, const Eigen::VectorXd& scaled)
{
    const Eigen::VectorXd x = scale.cwiseProduct(scaled);
    Eigen::Index largest = 0;
    x.cwiseAbs().maxCoeff(&largest);
    return x / x[largest];
}

} // namespace

NullModes null_modes(const SparseMatrix& K, double zero_tolerance, Eigen::Index most)
{
    NullModes result{.modes = Eigen::MatrixXd(K.rows(), 0), .softest = Eigen::VectorXd(K.rows())};
    if (K.rows() == 0) return result;
    const Eigen::VectorXd scale = unit_diagonal_scale(K);
    const SparseMatrix scaled = scale.asDiagonal() * K * scale.asDiagonal();
    const SoftMotions soft(scaled, zero_tolerance, most);
    const Eigen::Index zeros = soft.n_zeros();

    Eigen::MatrixXd modes = soft.vectors().leftCols(zeros);
    separate(modes);
    result.modes.resize(K.rows(), zeros);
    for (Eigen::Index i = 0; i < zeros; ++i) result.modes.col(i) = motion(scale, modes.col(i));
    result.is_complete = zeros < soft.values().size() || zeros == K.rows();
    if (zeros < soft.values().size()) {
        result.smallest_eigenvalue = soft.values()[zeros];
        result.softest = motion(scale, soft.vectors().col(zeros));
    }
    result.condition = zeros > 0 ? std::numeric_limits<double>::infinity()
                                 : norm_1(scaled) / result.smallest_eigenvalue;
    return result;
}

NullModes null_modes(const RowMatrix& A, const NullSearch& search,
                     const std::function<bool(const Eigen::VectorXd&)>& is_free)
{
    NullModes result{.modes = Eigen::MatrixXd(A.cols(), 0), .softest = Eigen::VectorXd::Zero(A.cols())};
    if (A.cols() == 0) return result;
    const Balanced whole = balanced(A, search.largest_entry);
    const SparseMatrix K = SparseMatrix(whole.A.transpose() * whole.A).triangularView<Eigen::Lower>();
    const SoftMotions soft(K, search.zero_tolerance, search.most);
    const Eigen::Index n_soft = soft.n_zeros();
    const Eigen::MatrixXd motions = by_strain(whole.A,
                                              corrected(whole.A, soft.inverse(), soft.vectors().leftCols(n_soft)));
    Eigen::MatrixXd free(A.cols(), 0);
    for (const auto candidate : motions.colwise()) {
        if (!is_free(motion(whole.scale, candidate))) continue;
        free.conservativeResize(Eigen::NoChange, free.cols() + 1);
        free.rightCols<1>() = candidate;
    }
    separate(free);
    result.modes.resize(A.cols(), free.cols());
    for (Eigen::Index i = 0; i < free.cols(); ++i) result.modes.col(i) = motion(whole.scale, free.col(i));
    result.is_complete = n_soft < soft.values().size() || n_soft == A.cols();
    return result;
}

double condition_estimate(const SymmetricSolver& solver, const SparseMatrix& K)
{
    const Eigen::Index n = K.cols();
    if (n == 0) return 1.0;
    const Eigen::VectorXd scale = unit_diagonal_scale(K);
    const auto inverse_times = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
        return solver.solve(x.cwiseQuotient(scale)).col(0).cwiseQuotient(scale);
    };
    // The largest column sum of the inverse: climb from the mean of all columns to better ones.
    Eigen::VectorXd x = Eigen::VectorXd::Constant(n, 1.0 / static_cast<double>(n));
    double norm = 0.0;
    Eigen::Index column = -1;
    constexpr int most_steps = 5;
    for (int step = 0; step < most_steps; ++step) {
        const Eigen::VectorXd y = inverse_times(x);
        if (y.lpNorm<1>() <= norm) break;
        norm = y.lpNorm<1>();
        const Eigen::VectorXd z = inverse_times(y.unaryExpr([](double v) { return v < 0.0 ? -1.0 : 1.0; }));
        Eigen::Index best = 0;
        if (z.cwiseAbs().maxCoeff(&best) <= z.dot(x) || best == column) break;
        column = best;
        x = Eigen::VectorXd::Unit(n, best);
    }
    const SparseMatrix scaled = scale.asDiagonal() * K * scale.asDiagonal();
    return norm * norm_1(scaled);
}

} // namespace femoop
