#include "femoop/solver/precise_solver.h"

#include <cmath>
#include <utility>

namespace femoop {

/// Eigen's L L' asks for it, which shares code with L D L'.
static DoubleDouble sqrt(DoubleDouble x) { return std::sqrt(x.hi); }

namespace {

constexpr int most_precise_steps = 60;
constexpr double finished = 1e-44;        // of the strain energy: the correction changes nothing any more
constexpr double satisfactory = 1e-20;    // where rounding of 32 digits ends the corrections sooner
constexpr double halting = 0.1;           // of the energy of the correction before: less than that is progress
constexpr double most_precise_work = 2e9; // of a factorization: it takes some ten seconds

/// The work that each column of R does on that of D.
Eigen::ArrayXd energies(const PreciseMatrix& D, const PreciseMatrix& R)
{
    return rounded(D.cwiseProduct(R).colwise().sum()).transpose().array().abs();
}

} // namespace

PreciseSolver::PreciseSolver(const PreciseSparseMatrix& K, const SymmetricSolver* rough) : K_(K), rough_(rough) {}

double PreciseSolver::Factorization::work() const { return m_nonZerosPerCol.cast<double>().squaredNorm(); }

std::optional<PreciseMatrix> PreciseSolver::solve(const PreciseMatrix& B)
{
    if (B.size() == 0) return B;
    if (rough_ != nullptr) {
        auto X = refined(
            B, [&](const PreciseMatrix& R) -> PreciseMatrix { return rough_->solve(rounded(R)).cast<DoubleDouble>(); });
        if (X) return X;
    }
    if (!factorize()) return std::nullopt;
    return refined(B, [&](const PreciseMatrix& R) -> PreciseMatrix { return factorization_.solve(R); });
}

template <class Correct>
std::optional<PreciseMatrix> PreciseSolver::refined(const PreciseMatrix& B, Correct&& correction) const
{
    PreciseMatrix X = PreciseMatrix::Zero(B.rows(), B.cols());
    PreciseMatrix R = B;
    Eigen::ArrayXd whole, before;
    for (int step = 0; step < most_precise_steps; ++step) {
        const PreciseMatrix D = correction(R);
        const Eigen::ArrayXd energy = energies(D, R);
        if (step == 0) whole = energy;
        const auto is_done = energy <= finished * whole;
        if (step > 0 && !(is_done || energy <= halting * before).all())
            return (before <= satisfactory * whole).all() ? std::optional(X) : std::nullopt;
        X += D;
        if (is_done.all()) return X;
        R = B - K_.selfadjointView<Eigen::Lower>() * X;
        before = energy;
    }
    return std::nullopt;
}

bool PreciseSolver::factorize()
{
    if (is_positive_) return *is_positive_;
    is_positive_ = false;
    factorization_.analyzePattern(K_);
    if (factorization_.work() > most_precise_work) return false;
    factorization_.factorize(K_);
    is_positive_ = factorization_.info() == Eigen::Success && (rounded(factorization_.vectorD()).array() > 0.0).all();
    return *is_positive_;
}

} // namespace femoop
