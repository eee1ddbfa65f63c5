#include "femoop/solver/refinement.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include "tests/femoop/solver/graph_kinds.h"

using namespace femoop;
using namespace femoop_test;

namespace {

/// Solves with the factor of another matrix, so that solutions are as wrong as it is.
class Careless final : public SymmetricSolver {
public:
    explicit Careless(double error) : error_(error) {}
    std::size_t factor_nonzeros() const override { return 0; }
    std::string_view name() const override { return "careless"; }

private:
    void analyse_ordered(Pattern) override {}
    Pivots factorize_ordered(const SparseMatrix& K, Signs) override
    {
        ldlt_.compute((1.0 + error_) * K);
        return {};
    }
    Eigen::MatrixXd solve_ordered(Eigen::MatrixXd B) const override { return ldlt_.solve(B); }

    double error_;
    Eigen::SimplicialLDLT<SparseMatrix> ldlt_;
};

} // namespace

TEST_CASE("Every correction takes as much of the error as the factor is right")
{
    const GraphSystem system(grid(9, 3), Ordering::MinimumDegree, 7);
    const Eigen::MatrixXd B = system.load(3);
    Careless solver(1e-3); // each correction leaves a thousandth
    solver.analyse(system.pattern);
    solver.factorize(system.K);
    const RefinedSolution refined = solve_refined(solver, system.K, B);
    CHECK(refined.n_steps >= 4);
    CHECK(refined.n_steps <= 6);
    CHECK(refined.backward_error <= 1e-15);
    const Eigen::MatrixXd X = system.dense().llt().solve(B);
    CHECK((refined.X - X).cwiseAbs().maxCoeff() <= 1e-11 * X.cwiseAbs().maxCoeff());
}

TEST_CASE("What cannot be improved stays as it was")
{
    const GraphSystem system(chain(20, 2), Ordering::MinimumDegree, 7);
    const Eigen::MatrixXd B = system.load(2);
    Careless solver(3.0); // a quarter of the solution: each correction leaves three quarters of the error
    solver.analyse(system.pattern);
    solver.factorize(system.K);
    const RefinedSolution refined = solve_refined(solver, system.K, B);
    CHECK(refined.n_steps == 0);
    CHECK(refined.X.isApprox(solver.solve(B)));
    CHECK(refined.backward_error > 0.1);
}

TEST_CASE("Refined solutions of ours are exact for a matrix that differs by rounding")
{
    for (const Definiteness definiteness : {Definiteness::Positive, Definiteness::Indefinite})
        for (const GraphKind& kind : graph_kinds) {
            CAPTURE(kind.name);
            const GraphSystem system(kind.make(kind.n, 3), Ordering::MinimumDegree, 11, definiteness);
            const auto solver = make_solver(SolverKind::Multifrontal);
            solver->analyse(system.pattern);
            REQUIRE(solver->factorize(system.K, Signs::Any).is_complete);
            CHECK(solve_refined(*solver, system.K, system.load(2)).backward_error <= 2e-15);
        }
}

TEST_CASE("A load of nothing is answered by nothing, exactly")
{
    const GraphSystem system(chain(5, 2), Ordering::MinimumDegree, 7);
    const auto solver = make_solver(SolverKind::Multifrontal);
    solver->analyse(system.pattern);
    solver->factorize(system.K);
    const RefinedSolution refined = solve_refined(*solver, system.K, Eigen::MatrixXd::Zero(system.K.rows(), 1));
    CHECK(refined.X.isZero(0.0));
    CHECK(refined.backward_error == 0.0);
}
