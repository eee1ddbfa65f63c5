#include "femoop/solver/cholmod_solver.h"

#include <algorithm>
#include <new>
#include <optional>
#include <stdexcept>

#include "femoop/solver/cholmod_session.h"
#include "femoop/solver/one_thread.h"

namespace femoop {

namespace {

constexpr double worth_blas_threads = 2e10; // operations, see courseware/decisions/0008-threads-where-they-pay.md

class CholmodSolver final : public SymmetricSolver {
public:
    CholmodSolver()
    {
        session_.common.nmethods = 1;
        session_.common.method[0].ordering = CHOLMOD_NATURAL; // equations come in the order of elimination
        session_.common.postorder = 0;                        // and of a postorder
        session_.common.supernodal = CHOLMOD_SUPERNODAL;
    }
    ~CholmodSolver() override { cholmod_free_factor(&factor_, &session_.common); }

    std::size_t factor_nonzeros() const override { return factor_ == nullptr ? 0 : factor_->xsize; }
    std::string_view name() const override { return "cholmod"; }

private:
    void analyse_ordered(Pattern pattern) override;
    Pivots factorize_ordered(const SparseMatrix& K, Signs signs) override;
    Eigen::MatrixXd solve_ordered(Eigen::MatrixXd B) const override;
    void require_done(bool is_done) const;

    std::optional<SerialBlas> serial_where_faster() const
    {
        return session_.common.fl < worth_blas_threads ? std::optional<SerialBlas>(std::in_place) : std::nullopt;
    }

    mutable CholmodSession session_; // workspace, no state
    cholmod_factor* factor_ = nullptr;
};

/// CHOLMOD's view of a lower triangle; it takes pointers to what it does not change.
cholmod_sparse view(std::span<const std::int32_t> column_start, const std::int32_t* rows, const double* values)
{
    cholmod_sparse K{};
    K.nrow = K.ncol = column_start.size() - 1;
    K.nzmax = static_cast<std::size_t>(column_start.back());
    K.p = const_cast<std::int32_t*>(column_start.data());
    K.i = const_cast<std::int32_t*>(rows);
    K.x = const_cast<double*>(values);
    K.stype = -1;
    K.itype = CHOLMOD_INT;
    K.xtype = values == nullptr ? CHOLMOD_PATTERN : CHOLMOD_REAL;
    K.dtype = CHOLMOD_DOUBLE;
    K.sorted = 1;
    K.packed = 1;
    return K;
}

void CholmodSolver::require_done(bool is_done) const
{
    if (session_.common.status == CHOLMOD_OUT_OF_MEMORY || session_.common.status == CHOLMOD_TOO_LARGE)
        throw std::bad_alloc();
    if (!is_done) throw std::runtime_error("CHOLMOD failed with status " + std::to_string(session_.common.status));
}

void CholmodSolver::analyse_ordered(Pattern pattern)
{
    cholmod_free_factor(&factor_, &session_.common);
    cholmod_sparse K = view(pattern.column_start, pattern.rows.data(), nullptr);
    factor_ = cholmod_analyze(&K, &session_.common);
    require_done(factor_ != nullptr);
}

/// Calls visit(equation, entry of L) down the diagonal of L until it returns false.
template <class Visit> void visit_diagonal(const cholmod_factor& L, Visit&& visit)
{
    const auto* const super = static_cast<const std::int32_t*>(L.super);
    const auto* const row_start = static_cast<const std::int32_t*>(L.pi);
    const auto* const value_start = static_cast<const std::int32_t*>(L.px);
    const auto* const values = static_cast<const double*>(L.x);
    for (std::size_t s = 0; s < L.nsuper; ++s) {
        const std::ptrdiff_t height = row_start[s + 1] - row_start[s];
        for (std::int32_t column = super[s]; column < super[s + 1]; ++column)
            if (!visit(column, values[value_start[s] + (column - super[s]) * (height + 1)])) return;
    }
}

Pivots CholmodSolver::factorize_ordered(const SparseMatrix& K, Signs signs)
{
    if (signs != Signs::Positive)
        throw std::invalid_argument("CHOLMOD's L L' has the roots of the pivots, which must be positive; "
                                    "take another solver for an indefinite matrix");
    const auto n = static_cast<std::size_t>(K.cols());
    cholmod_sparse view_of_K = view(std::span(K.outerIndexPtr(), n + 1), K.innerIndexPtr(), K.valuePtr());
    const SerialLoops serial; // a team of threads for the scatter of each supernode costs more than the scatter
    const std::optional<SerialBlas> serial_blas = serial_where_faster();
    require_done(cholmod_factorize(&view_of_K, factor_, &session_.common) != 0);
    const auto broke_down = static_cast<std::int32_t>(std::min(factor_->minor, n));
    Pivots pivots;
    visit_diagonal(*factor_, [&](std::int32_t equation, double l) {
        const double diagonal = K.valuePtr()[K.outerIndexPtr()[equation]];
        return pivots.note(equation, equation < broke_down ? l * l : 0.0, diagonal);
    });
    return pivots;
}

Eigen::MatrixXd CholmodSolver::solve_ordered(Eigen::MatrixXd B) const
{
    cholmod_dense view_of_B{};
    view_of_B.nrow = view_of_B.d = static_cast<std::size_t>(B.rows());
    view_of_B.ncol = static_cast<std::size_t>(B.cols());
    view_of_B.nzmax = static_cast<std::size_t>(B.size());
    view_of_B.x = B.data();
    view_of_B.xtype = CHOLMOD_REAL;
    view_of_B.dtype = CHOLMOD_DOUBLE;
    const std::optional<SerialBlas> serial_blas = serial_where_faster();
    cholmod_dense* X = cholmod_solve(CHOLMOD_A, factor_, &view_of_B, &session_.common);
    require_done(X != nullptr);
    std::copy_n(static_cast<const double*>(X->x), B.size(), B.data());
    cholmod_free_dense(&X, &session_.common);
    return B;
}

} // namespace

bool has_cholmod() { return true; }
std::unique_ptr<SymmetricSolver> make_cholmod_solver() { return std::make_unique<CholmodSolver>(); }

} // namespace femoop
