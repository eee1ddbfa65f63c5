#include "femoop/solver/symmetric_solver.h"

#include <doctest/doctest.h>

#include <Eigen/Cholesky>

#include "tests/femoop/solver/random_system.h"

using namespace femoop;
using femoop_test::RandomSystem;

namespace {

std::vector<SolverKind> solvers()
{
    std::vector<SolverKind> kinds = available_solvers();
    std::erase(kinds, SolverKind::Automatic);
    return kinds;
}

Eigen::MatrixXd random_columns(Eigen::Index rows, Eigen::Index columns)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return uniform(random); });
}

/// Springs k[i] in a row, the first one to the ground.
SparseMatrix chain(const std::vector<double>& k)
{
    const auto n = static_cast<Eigen::Index>(k.size());
    SparseMatrix K(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        K.insert(i, i) = k[at] + (at + 1 < k.size() ? k[at + 1] : 0.0);
        if (at + 1 < k.size()) K.insert(i + 1, i) = -k[at + 1];
    }
    K.makeCompressed();
    return K;
}

} // namespace

TEST_CASE("Every solver in every ordering finds what a dense solver finds, for many right-hand sides")
{
    for (const SolverKind kind : solvers())
        for (const Ordering ordering : {Ordering::CuthillMcKee, Ordering::MinimumDegree, Ordering::NestedDissection})
            for (unsigned seed = 1; seed <= 5; ++seed) {
                CAPTURE(name(kind));
                CAPTURE(static_cast<int>(ordering));
                CAPTURE(seed);
                const RandomSystem system(seed, 60, 90, ordering);
                const Eigen::MatrixXd B = random_columns(system.dense.rows(), 5);
                const auto solver = make_solver(kind);
                solver->analyse(system.pattern);
                REQUIRE(solver->factorize(system.K).is_positive_definite);
                const Eigen::MatrixXd X = system.dense.llt().solve(B);
                CHECK((solver->solve(B) - X).cwiseAbs().maxCoeff() <= 1e-10 * X.cwiseAbs().maxCoeff());
                CHECK(solver->factor_nonzeros() >= static_cast<std::size_t>(system.K.cols()));
            }
}

TEST_CASE("A matrix in any order is put in order by the solver itself")
{
    for (const SolverKind kind : solvers()) {
        CAPTURE(name(kind));
        const RandomSystem system(11, 60, 90, Ordering::CuthillMcKee);
        const Eigen::MatrixXd B = random_columns(system.dense.rows(), 3);
        const auto solver = make_solver(kind);
        solver->analyse(system.K);
        const Pivots pivots = solver->factorize(system.K);
        REQUIRE(pivots.is_positive_definite);
        const Eigen::MatrixXd X = system.dense.llt().solve(B);
        CHECK((solver->solve(B) - X).cwiseAbs().maxCoeff() <= 1e-10 * X.cwiseAbs().maxCoeff());
    }
}

TEST_CASE("New numbers need no new analysis")
{
    for (const SolverKind kind : solvers()) {
        CAPTURE(name(kind));
        RandomSystem system(13, 40, 60, Ordering::MinimumDegree);
        const Eigen::MatrixXd B = random_columns(system.dense.rows(), 2);
        const auto solver = make_solver(kind);
        solver->analyse(system.pattern);
        solver->factorize(system.K);
        const Eigen::MatrixXd before = solver->solve(B);
        system.K *= 3.7;
        REQUIRE(solver->factorize(system.K).is_positive_definite);
        CHECK((3.7 * solver->solve(B) - before).cwiseAbs().maxCoeff() <= 1e-11 * before.cwiseAbs().maxCoeff());
    }
}

TEST_CASE("In a chain of springs the last pivot is k1 k2 k3 / (k1 k2 + k2 k3 + k3 k1)")
{
    const double k1 = 7.0, k2 = 0.5, k3 = 3.0;
    const SparseMatrix K = chain({k1, k2, k3}); // eliminated from the ground to the tip
    BlockGraph graph;
    graph.block_sizes = {1, 1, 1};
    for (const SolverKind kind : solvers()) {
        CAPTURE(name(kind));
        const auto solver = make_solver(kind);
        solver->analyse(K, Ordering::MinimumDegree);
        const Pivots pivots = solver->factorize(K);
        const double tip = k1 * k2 * k3 / (k1 * k2 + k2 * k3 + k3 * k1); // stiffness felt at the tip
        CHECK(pivots.is_positive_definite);
        CHECK(Eigen::VectorXd(solver->solve(Eigen::Vector3d::UnitZ()))[2] == doctest::Approx(1.0 / tip));
        CHECK(pivots.smallest_ratio > 0.0);
        CHECK(pivots.smallest_ratio < 1.0);
    }
}

TEST_CASE("A spring of 1e-9 among springs of 1 leaves a pivot ratio near 1e-9 and is still solved")
{
    const double soft = 1e-9;
    const SparseMatrix K = chain({soft, 1.0, 2.0, 5.0});
    for (const SolverKind kind : solvers()) {
        CAPTURE(name(kind));
        const auto solver = make_solver(kind);
        solver->analyse(K);
        const Pivots pivots = solver->factorize(K);
        REQUIRE(pivots.is_positive_definite);
        CHECK(pivots.smallest_ratio < 1e-8);
        CHECK(pivots.smallest_ratio > 1e-10);
        CHECK(solver->solve(Eigen::Vector4d::UnitX())(0, 0) == doctest::Approx(1.0 / soft).epsilon(1e-6));
    }
}

TEST_CASE("Without its spring to the ground a chain has no pivot left, and the place is named")
{
    const SparseMatrix K = chain({0.0, 1.0, 2.0, 4.0}); // these numbers cancel exactly
    for (const SolverKind kind : solvers()) {
        CAPTURE(name(kind));
        const auto solver = make_solver(kind);
        solver->analyse(K);
        const Pivots pivots = solver->factorize(K);
        CHECK_FALSE(pivots.is_positive_definite);
        CHECK(pivots.smallest_ratio == 0.0);
        CHECK(pivots.weakest >= 0);
        CHECK(pivots.weakest < 4);
    }
}

TEST_CASE("A row without stiffness is named as the place where elimination stops")
{
    SparseMatrix K(3, 3);
    K.insert(0, 0) = 5.0;
    K.insert(1, 1) = 0.0;
    K.insert(2, 2) = 3.0;
    K.makeCompressed();
    for (const SolverKind kind : solvers()) {
        CAPTURE(name(kind));
        const auto solver = make_solver(kind);
        solver->analyse(K);
        const Pivots pivots = solver->factorize(K);
        CHECK_FALSE(pivots.is_positive_definite);
        CHECK(pivots.weakest == 1);
    }
}

TEST_CASE("A system without unknowns has a solution without numbers")
{
    for (const SolverKind kind : solvers()) {
        CAPTURE(name(kind));
        const auto solver = make_solver(kind);
        solver->analyse(SystemPattern(BlockGraph{}, kind));
        CHECK(solver->factorize(SparseMatrix(0, 0)).is_positive_definite);
        CHECK(solver->solve(Eigen::MatrixXd(0, 2)).cols() == 2);
    }
}

TEST_CASE("Solvers are known by the names that the command line takes")
{
    for (const SolverKind kind : available_solvers()) CHECK(solver_named(name(kind)) == kind);
    CHECK_FALSE(solver_named("pardiso").has_value());
    CHECK_THROWS_AS(make_solver(SolverKind::Automatic), std::invalid_argument);
}
