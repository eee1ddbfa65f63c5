#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "femoop/solver/multifrontal/dense_front.h"
#include "femoop/solver/multifrontal/multifrontal_solver.h"
#include "tests/femoop/solver/graph_kinds.h"
#include "tests/samples.h"

using namespace femoop;
using namespace femoop_test;

namespace {

Eigen::Index n_below(const Eigen::VectorXd& values, double limit) { return (values.array() < limit).count(); }

/// K - s M.
SparseMatrix shifted(const SparseMatrix& K, double s, const Eigen::VectorXd& M)
{
    SparseMatrix result = K;
    for (Eigen::Index i = 0; i < K.cols(); ++i) result.coeffRef(i, i) -= s * M[i];
    return result;
}

double backward_error(const SparseMatrix& K, const Eigen::MatrixXd& X, const Eigen::MatrixXd& B)
{
    const Eigen::MatrixXd whole = Eigen::MatrixXd(K).selfadjointView<Eigen::Lower>();
    return residual(K, X, B) /
           (whole.cwiseAbs().rowwise().sum().maxCoeff() * X.cwiseAbs().maxCoeff() + B.cwiseAbs().maxCoeff());
}

/// [K C'; C 0]: unknowns in a chain, of which a multiplier makes two equal.
SparseMatrix with_multipliers(Eigen::Index n, const std::vector<Eigen::Index>& tied_to_next)
{
    SparseMatrix A(n + static_cast<Eigen::Index>(tied_to_next.size()),
                   n + static_cast<Eigen::Index>(tied_to_next.size()));
    for (Eigen::Index i = 0; i < n; ++i) {
        A.insert(i, i) = 2.0;
        if (i > 0) A.insert(i, i - 1) = -1.0;
    }
    for (std::size_t m = 0; m < tied_to_next.size(); ++m) {
        const Eigen::Index row = n + static_cast<Eigen::Index>(m);
        A.insert(row, tied_to_next[m]) = 1.0;
        A.insert(row, tied_to_next[m] + 1) = -1.0;
        A.insert(row, row) = 0.0;
    }
    A.makeCompressed();
    return A;
}

} // namespace

TEST_CASE("Indefinite systems of every kind are solved in every order, and signs of pivots are those of eigenvalues")
{
    for (const GraphKind& kind : graph_kinds)
        for (const Ordering ordering : orderings)
            for (unsigned size = 1; size <= samples(6, 3); ++size) {
                CAPTURE(kind.name);
                CAPTURE(static_cast<int>(ordering));
                CAPTURE(size);
                const GraphSystem system(kind.make(kind.n, size), ordering, 23, Definiteness::Indefinite);
                MultifrontalSolver solver;
                solver.analyse(system.pattern);
                const Pivots pivots = solver.factorize(system.K, Signs::Any);
                REQUIRE(pivots.is_complete);
                const Eigen::VectorXd w = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(system.dense()).eigenvalues();
                CHECK(pivots.n_negative == n_below(w, 0.0));
                CHECK(pivots.is_positive_definite == (w.minCoeff() > 0.0));
                const Eigen::MatrixXd B = system.load(3);
                CHECK(backward_error(system.K, solver.solve(B), B) <= 1e-11);
            }
}

TEST_CASE("K - s M has as many negative pivots as there are eigenvalues below s, in every solver that takes any signs")
{
    const GraphSystem system(grid(8, 3), Ordering::NestedDissection, 31);
    const Eigen::VectorXd M = Eigen::VectorXd::LinSpaced(system.K.cols(), 0.5, 2.0);
    const Eigen::MatrixXd mass = M.asDiagonal();
    const Eigen::VectorXd w =
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(system.dense(), mass).eigenvalues();
    for (const SolverKind kind : {SolverKind::Multifrontal, SolverKind::Skyline, SolverKind::Ldlt}) {
        CAPTURE(name(kind));
        const auto solver = make_solver(kind);
        solver->analyse(system.pattern);
        for (const double part : {0.0, 0.03, 0.2, 0.5, 0.9, 1.0}) {
            const auto k = static_cast<Eigen::Index>(part * static_cast<double>(w.size() - 2));
            const double s = 0.5 * (w[k] + w[k + 1]);
            CHECK(solver->factorize(shifted(system.K, s, M), Signs::Any).n_negative == k + 1);
        }
        CHECK(solver->factorize(shifted(system.K, 0.5 * w[0], M), Signs::Any).is_positive_definite);
    }
}

TEST_CASE("One thread or eight: an indefinite system has the same solution to the last bit")
{
    const GraphSystem system(grid(60, 3), Ordering::NestedDissection, 41, Definiteness::Indefinite);
    const Eigen::MatrixXd B = system.load(2);
    MultifrontalSolver alone(1);
    alone.analyse(system.pattern);
    const Pivots expected = alone.factorize(system.K, Signs::Any);
    REQUIRE(expected.is_complete);
    const Eigen::MatrixXd X = alone.solve(B);
    CHECK(backward_error(system.K, X, B) <= 1e-10);
    for (const int n_threads : {2, 3, 8}) {
        CAPTURE(n_threads);
        MultifrontalSolver together(n_threads);
        together.analyse(system.pattern);
        const Pivots pivots = together.factorize(system.K, Signs::Any);
        CHECK(pivots.n_negative == expected.n_negative);
        CHECK(pivots.smallest_ratio == expected.smallest_ratio);
        CHECK(together.solve(B) == X);
    }
}

TEST_CASE("A multiplier has no stiffness of its own: one negative pivot for each constraint")
{
    for (const Ordering ordering : orderings) {
        CAPTURE(static_cast<int>(ordering));
        const SparseMatrix A = with_multipliers(12, {2, 5, 6, 9});
        MultifrontalSolver solver;
        solver.analyse(A, ordering);
        const Pivots pivots = solver.factorize(A, Signs::Any);
        REQUIRE(pivots.is_complete);
        CHECK(pivots.n_negative == 4);
        const Eigen::VectorXd x = solver.solve(Eigen::VectorXd::Ones(A.cols()).cwiseProduct(
            (Eigen::VectorXd(A.cols()) << Eigen::VectorXd::Ones(12), Eigen::VectorXd::Zero(4)).finished()));
        for (const Eigen::Index tied : {2, 5, 6, 9}) CHECK(x[tied] == doctest::Approx(x[tied + 1]));
    }
}

TEST_CASE("Only where signs may be any does elimination go on behind a negative pivot")
{
    SparseMatrix K(3, 3);
    K.insert(0, 0) = 4.0;
    K.insert(1, 1) = -3.0;
    K.insert(2, 2) = 5.0;
    K.makeCompressed();
    for (const SolverKind kind : {SolverKind::Multifrontal, SolverKind::Skyline, SolverKind::Ldlt}) {
        CAPTURE(name(kind));
        const auto solver = make_solver(kind);
        solver->analyse(K);
        const Pivots stopped = solver->factorize(K);
        CHECK_FALSE(stopped.is_complete);
        CHECK_FALSE(stopped.is_positive_definite);
        CHECK(stopped.weakest == 1);
        const Pivots all = solver->factorize(K, Signs::Any);
        CHECK(all.is_complete);
        CHECK_FALSE(all.is_positive_definite);
        CHECK(all.n_negative == 1);
        CHECK(solver->solve(Eigen::Vector3d(8.0, 3.0, 10.0)).isApprox(Eigen::Vector3d(2.0, -1.0, 2.0)));
    }
    if (is_available(SolverKind::Cholmod)) {
        const auto solver = make_solver(SolverKind::Cholmod);
        solver->analyse(K);
        CHECK_THROWS_AS(solver->factorize(K, Signs::Any), std::invalid_argument);
    }
}

TEST_CASE("A row of zeros is named where signs may be any, too")
{
    SparseMatrix K(3, 3);
    K.insert(0, 0) = 4.0;
    K.insert(1, 1) = 0.0;
    K.insert(2, 2) = -5.0;
    K.makeCompressed();
    for (const SolverKind kind : {SolverKind::Multifrontal, SolverKind::Skyline, SolverKind::Ldlt}) {
        CAPTURE(name(kind));
        const auto solver = make_solver(kind);
        solver->analyse(K);
        const Pivots pivots = solver->factorize(K, Signs::Any);
        CHECK_FALSE(pivots.is_complete);
        CHECK(pivots.weakest == 1);
        CHECK(pivots.smallest_ratio == 0.0);
    }
}

TEST_CASE("With pivots exchanged a front's elimination leaves L D L' of the rows in their new order")
{
    for (const std::int32_t n : {1, 2, 7, 25, 96, 97, 230})
        for (const std::int32_t m : {0, 1, 50, 400}) {
            CAPTURE(n);
            CAPTURE(m);
            std::srand(4);
            const Eigen::MatrixXd R = Eigen::MatrixXd::Random(n + m, n + m);
            Eigen::MatrixXd K = R + R.transpose();
            if (n > 1) K.diagonal().setZero(); // no pivot stands by itself at first
            Eigen::MatrixXd panel = K.leftCols(n), update = K.bottomRightCorner(m, m);
            std::vector<double> workspace(workspace_size(n, n + m)), coupling(at(n));
            std::vector<std::int32_t> order(at(n));
            const DenseFront front{panel.data(), update.data(), n, n + m, order.data(), coupling.data()};
            REQUIRE(dense_kernel().eliminate(front, workspace.data(), one_by_one) == n);

            const Eigen::MatrixXd L = panel.topRows(n).triangularView<Eigen::UnitLower>();
            Eigen::MatrixXd D = panel.topRows(n).diagonal().asDiagonal();
            for (Eigen::Index i = 0; i + 1 < n; ++i) D(i, i + 1) = D(i + 1, i) = coupling[static_cast<std::size_t>(i)];
            Eigen::MatrixXd exchanged(n, n);
            for (Eigen::Index i = 0; i < n; ++i)
                for (Eigen::Index j = 0; j < n; ++j)
                    exchanged(i, j) = K(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(j)]);
            const double scale = K.cwiseAbs().maxCoeff(), growth = 1e3;
            CHECK((L * D * L.transpose() - exchanged).cwiseAbs().maxCoeff() <= growth * 1e-12 * scale);
            if (m == 0) continue;
            const Eigen::MatrixXd schur = K.bottomRightCorner(m, m) -
                                          K.bottomLeftCorner(m, n) * K.topLeftCorner(n, n).fullPivLu().solve(
                                                                         Eigen::MatrixXd(K.topRightCorner(n, m)));
            const double largest = schur.cwiseAbs().maxCoeff();
            for (Eigen::Index j = 0; j < m; ++j)
                CHECK((update.col(j).tail(m - j) - schur.col(j).tail(m - j)).cwiseAbs().maxCoeff() <= 1e-9 * largest);
        }
}
