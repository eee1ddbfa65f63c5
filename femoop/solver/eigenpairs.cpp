#include "femoop/solver/eigenpairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>

#include "femoop/algebra/symmetric_eigen.h"
#include "femoop/solver/available_memory.h"

namespace femoop {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index lanczos_block = 4;        // a plane body that floats has three motions of 0 Hz
constexpr double converged = 1e-9;        // residual of a pair, of its value
constexpr double nearly_converged = 1e-4; // the same of a pair that only bounds the count
constexpr double nothing_new = 1e-10;     // of a vector, left square to all others
constexpr double a_gap = 1e-6;            // between eigenvalues that Sturm's count tells apart, of the upper one

MatrixXd random_block(Index rows, Index columns, std::mt19937_64& random)
{
    constexpr double largest = static_cast<double>(std::mt19937_64::max());
    return MatrixXd::NullaryExpr(rows, columns, [&] { return static_cast<double>(random()) / largest - 0.5; });
}

/// The largest K_ii / M_ii: of the order of the largest eigenvalue; and the smallest: no lowest one is above it.
std::pair<double, double> diagonal_range(const SparseMatrix& K, const SparseMatrix& M)
{
    const VectorXd stiffness = K.diagonal(), mass = M.diagonal();
    double least = 0.0, most = 0.0;
    for (Index i = 0; i < mass.size(); ++i) {
        if (!(mass[i] > 0.0)) continue;
        const double ratio = stiffness[i] / mass[i];
        least = most > 0.0 ? std::min(least, ratio) : ratio;
        most = std::max(most, ratio);
    }
    return {least, most};
}

/// A space that grows by what the inverse makes of its newest vectors, and its best approximations.
class LanczosSpace {
public:
    LanczosSpace(const SparseMatrix& M, const SymmetricSolver& inverse, Index most)
        : M_(M), inverse_(inverse), Q_(M.rows(), most), H_(MatrixXd::Zero(most, most))
    {
        add_random();
    }

    Index size() const { return n_; }
    bool has_room() const { return n_ + pending_.cols() <= Q_.cols(); }
    bool is_exhausted() const { return pending_.cols() == 0; } ///< it holds every motion that has mass

    /// Takes in the newest block, and finds the next. \pre has_room, !is_exhausted
    void extend()
    {
        const Index added = pending_.cols();
        Q_.middleCols(n_, added) = pending_;
        n_ += added;
        MatrixXd W = inverse_.solve(times_mass(pending_));
        const VectorXd sizes = norms(W);
        const MatrixXd h = made_square(W);
        pending_.resize(Eigen::NoChange, 0);
        H_.block(0, n_ - added, n_, added) = h;
        H_.block(n_ - added, 0, added, n_) = h.transpose();
        coupling_ = normalize(W, sizes);
        n_last_ = added;
        if (pending_.cols() == 0) add_random(); // of equal values each block finds some only
        approximate();
    }

    /// Values of the inverse, largest first, and how far each pair is from one.
    const VectorXd& values() const { return values_; }
    double residual(Index i) const { return (coupling_ * S_.col(i).middleRows(n_ - n_last_, n_last_)).norm(); }
    bool holds(Index i, double tolerance) const { return is_exhausted() || residual(i) <= tolerance * values_[i]; }

    MatrixXd vectors(Index count) const { return Q_.leftCols(n_) * S_.leftCols(count); }

    /// Keeps the best of it only.
    void restart(Index kept)
    {
        Q_.leftCols(kept) = vectors(kept);
        H_.setZero();
        H_.diagonal().head(kept) = values_.head(kept);
        n_ = kept;
    }

    /// Looks in new directions too.
    void add_random()
    {
        const Index n_known = pending_.cols();
        MatrixXd W = inverse_.solve(times_mass(random_block(M_.rows(), std::min(lanczos_block, M_.rows()), random_)));
        const VectorXd sizes = norms(W);
        made_square(W);
        normalize(W, sizes);
        MatrixXd coupling = MatrixXd::Zero(pending_.cols(), coupling_.cols());
        coupling.topRows(n_known) = coupling_.topRows(n_known);
        coupling_ = std::move(coupling);
    }

private:
    static constexpr int passes = 2; // of making vectors square to others: twice is enough

    MatrixXd times_mass(const MatrixXd& X) const { return M_.selfadjointView<Eigen::Lower>() * X; }
    VectorXd norms(const MatrixXd& X) const
    {
        return X.cwiseProduct(times_mass(X)).colwise().sum().cwiseMax(0.0).cwiseSqrt();
    }

    /// Takes from W what the space holds already, and tells how much that was.
    MatrixXd made_square(MatrixXd& W) const
    {
        MatrixXd taken = MatrixXd::Zero(n_, W.cols());
        for (int pass = 0; pass < passes; ++pass) {
            const MatrixXd part = Q_.leftCols(n_).transpose() * times_mass(W);
            W -= Q_.leftCols(n_) * part;
            taken += part;
        }
        return taken;
    }

    /// Adds to the pending block what is new in W: W = pending R.
    MatrixXd normalize(const MatrixXd& W, const VectorXd& sizes)
    {
        MatrixXd R = MatrixXd::Zero(pending_.cols() + W.cols(), W.cols());
        for (Index c = 0; c < W.cols(); ++c) {
            MatrixXd w = W.col(c);
            for (int pass = 0; pass < passes; ++pass) {
                const MatrixXd part = pending_.transpose() * times_mass(w);
                w -= pending_ * part;
                R.block(0, c, part.rows(), 1) += part;
            }
            const double norm = norms(w)[0];
            if (!(norm > nothing_new * sizes[c])) continue;
            R(pending_.cols(), c) = norm;
            pending_.conservativeResize(Eigen::NoChange, pending_.cols() + 1);
            pending_.rightCols<1>() = w / norm;
        }
        return R.topRows(pending_.cols());
    }

    void approximate()
    {
        const MatrixXd H = H_.topLeftCorner(n_, n_);
        const SymmetricEigen eigen = symmetric_eigen(0.5 * (H + H.transpose()));
        values_ = eigen.values.reverse();
        S_ = eigen.vectors.rowwise().reverse();
    }

    const SparseMatrix& M_;
    const SymmetricSolver& inverse_;
    std::mt19937_64 random_; // of one seed, so that a model has one answer
    MatrixXd Q_;             ///< the space
    MatrixXd H_;             ///< the inverse in it
    Index n_ = 0, n_last_ = 0;
    MatrixXd pending_ = MatrixXd(M_.rows(), 0);
    MatrixXd coupling_ = MatrixXd(0, 0); ///< of the newest block in the space with the pending one
    VectorXd values_;
    MatrixXd S_;
};

class LowestPairs {
public:
    LowestPairs(const SparseMatrix& K, const SparseMatrix& M, Index wanted, SymmetricSolver& solver)
        : K_(K), M_(M), solver_(solver), wanted_(wanted), diagonal_(diagonal_range(K, M))
    {}

    Eigenpairs find()
    {
        constexpr Index spare = 24;
        const Index most = std::min(M_.rows(), 3 * wanted_ + spare) + lanczos_block;
        require_room(most);
        factorize();
        LanczosSpace space(M_, solver_, most);
        bool is_counted = false;
        Index n = 0;
        for (int tries = 0; tries < most_tries && !is_counted; ++tries) {
            if (tries > 0 && !space.is_exhausted()) space.add_random();
            n = iterate(space);
            is_counted = space.is_exhausted() || count_below_gap(space, n);
            if (is_counted) break;
            factorize();
        }
        return pairs(space, space.is_exhausted() ? with_equal_ones(space) : n, is_counted);
    }

private:
    static constexpr int most_tries = 6;
    static constexpr int most_blocks = 400;

    /// For the space, and the vectors that are taken from it.
    void require_room(Index columns) const
    {
        const double needed = 2.0 * sizeof(double) * static_cast<double>(M_.rows()) * static_cast<double>(columns);
        const double available = available_memory();
        if (needed > available) throw InsufficientMemory(needed, available);
    }

    void factorize()
    {
        constexpr double held = 1e-11; // of a diagonal entry: is left where nothing moves freely
        constexpr double below = 1e-7; // of a bound of the lowest eigenvalue that is not 0
        if (shift_ == 0.0) {
            const Pivots pivots = solver_.factorize(K_);
            if (pivots.is_complete && pivots.smallest_ratio > held) return;
            shift_ = -below * diagonal_.first;
        }
        if (!solver_.factorize(shifted(shift_)).is_complete)
            throw std::domain_error("lowest_eigenpairs: something moves that has neither stiffness nor mass");
    }

    SparseMatrix shifted(double shift) const { return K_ - shift * M_; }
    double eigenvalue(double of_inverse) const { return shift_ + 1.0 / of_inverse; }

    /// Until the wanted pairs hold, and those behind them up to a gap; returns how many these are.
    Index iterate(LanczosSpace& space) const
    {
        for (int block = 0; block < most_blocks && !space.is_exhausted(); ++block) {
            if (!space.has_room()) space.restart(std::min(space.size(), wanted_ + 2 * lanczos_block));
            space.extend();
            if (const auto n = pairs_to_gap(space)) return *n;
        }
        return std::min(space.size(), wanted_);
    }

    std::optional<Index> pairs_to_gap(const LanczosSpace& space) const
    {
        Index n = 0;
        for (; n + 1 < space.size() && space.values()[n] > 0.0 && space.holds(n, converged); ++n) {
            const bool bounds = space.values()[n + 1] > 0.0 && space.holds(n + 1, nearly_converged);
            if (n + 1 >= wanted_ && bounds && is_gap(space, n + 1)) return n + 1;
        }
        return std::nullopt;
    }

    /// How many are wanted, with those that have the value of the last.
    Index with_equal_ones(const LanczosSpace& space) const
    {
        Index n = std::min(space.size(), wanted_);
        while (n < space.size() && !is_gap(space, n)) ++n;
        return n;
    }

    /// Do the n-th value and the next differ?
    bool is_gap(const LanczosSpace& space, Index n) const
    {
        const double low = eigenvalue(space.values()[n - 1]), high = eigenvalue(space.values()[n]);
        return high - low > a_gap * (high - shift_);
    }

    /// Are there no more below the gap behind the n-th than n?
    bool count_below_gap(const LanczosSpace& space, Index n)
    {
        if (n >= space.size()) return false;
        const double low = eigenvalue(space.values()[n - 1]), high = eigenvalue(space.values()[n]);
        const Pivots pivots = solver_.factorize(shifted(0.5 * (low + high)), Signs::Any);
        return pivots.is_complete && pivots.n_negative == n;
    }

    Eigenpairs pairs(const LanczosSpace& space, Index most, bool is_counted) const
    {
        constexpr double digits = 1e-15;
        constexpr double of_mass = 1e-13; // of the largest value of the inverse: less is a motion without mass
        Index n = 0;
        while (n < std::min(space.size(), most) && space.values()[n] > of_mass * space.values()[0]) ++n;
        Eigenpairs found{.values = VectorXd(n), .vectors = space.vectors(n), .is_counted = is_counted};
        for (Index i = 0; i < n; ++i) found.values[i] = eigenvalue(space.values()[i]);
        found.rounding = digits * diagonal_.second;
        return found;
    }

    const SparseMatrix& K_;
    const SparseMatrix& M_;
    SymmetricSolver& solver_;
    Index wanted_;
    std::pair<double, double> diagonal_;
    double shift_ = 0.0;
};

} // namespace

Eigenpairs lowest_eigenpairs(const SparseMatrix& K, const SparseMatrix& M, std::size_t wanted, SymmetricSolver& solver)
{
    const auto most = std::min(static_cast<Index>(wanted), K.rows());
    const double mass = most > 0 ? M.diagonal().maxCoeff<Eigen::PropagateNaN>() : 0.0;
    if (mass == 0.0) return {.values = VectorXd(0), .vectors = MatrixXd(K.rows(), 0)};
    const double stiffness = K.diagonal().maxCoeff<Eigen::PropagateNaN>(), of_one = stiffness / mass;
    constexpr double largest = std::numeric_limits<double>::max();
    if (!(mass <= largest && stiffness <= largest && of_one <= largest && of_one > 0.0))
        throw std::range_error("lowest_eigenpairs: stiffness or mass is beyond the range of numbers");
    const SparseMatrix unit_K = K / stiffness, unit_M = M / mass; // so that no product of them leaves that range
    Eigenpairs found = LowestPairs(unit_K, unit_M, most, solver).find();
    found.values *= of_one;
    found.rounding *= of_one;
    found.vectors /= std::sqrt(mass);
    return found;
}

} // namespace femoop
