// Progress and cancellation, and memory that is asked for before it is taken.
#include <doctest/doctest.h>

#include <limits>
#include <vector>

#include "femoop/solver/available_memory.h"
#include "femoop/solver/multifrontal/multifrontal_solver.h"
#include "tests/femoop/solver/graph_kinds.h"

using namespace femoop;
using namespace femoop_test;

TEST_CASE("Progress grows from nothing to all of it, whatever the threads")
{
    const GraphSystem system(grid(60, 3), Ordering::NestedDissection, 29);
    for (const int n_threads : {1, 2, 4}) {
        CAPTURE(n_threads);
        MultifrontalSolver solver(n_threads);
        std::vector<double> shares;
        solver.set_progress([&](double share) {
            shares.push_back(share);
            return true;
        });
        solver.analyse(system.pattern);
        CHECK(solver.factorize(system.K).is_complete);
        CHECK(shares.size() > 5);
        CHECK(shares.front() == 0.0);
        CHECK(shares.back() == 1.0);
        for (std::size_t i = 1; i < shares.size(); ++i) CHECK(shares[i] >= shares[i - 1]);
    }
}

TEST_CASE("A cancelled factorization leaves the solver as after its analysis, wherever it was")
{
    const GraphSystem system(grid(60, 3), Ordering::NestedDissection, 29);
    const Eigen::MatrixXd B = system.load(2);
    for (const int n_threads : {1, 2, 8})
        for (const double end : {0.0, 0.2, 0.7, 0.95, 1.0}) {
            CAPTURE(n_threads);
            CAPTURE(end);
            MultifrontalSolver solver(n_threads);
            solver.analyse(system.pattern);
            solver.set_progress([&](double share) { return share < end; });
            CHECK_THROWS_AS(solver.factorize(system.K), Cancelled);
            CHECK_THROWS_AS(solver.factorize(system.K, Signs::Any), Cancelled);
            solver.set_progress({});
            REQUIRE(solver.factorize(system.K).is_complete);
            CHECK(residual(system.K, solver.solve(B), B) <= 1e-8);
        }
}

TEST_CASE("Every solver asks before it begins")
{
    const GraphSystem system(chain(20, 2), Ordering::MinimumDegree, 3);
    for (const SolverKind kind : available_solvers()) {
        if (kind == SolverKind::Automatic) continue;
        CAPTURE(name(kind));
        const auto solver = make_solver(kind);
        solver->analyse(system.pattern);
        solver->set_progress([](double) { return false; });
        CHECK_THROWS_AS(solver->factorize(system.K), Cancelled);
        solver->set_progress({});
        CHECK(solver->factorize(system.K).is_complete);
    }
}

TEST_CASE("What does not fit is refused before it is taken, with what it needs and what there is")
{
    const GraphSystem system(grid(40, 3), Ordering::NestedDissection, 5);
    MultifrontalSolver solver(2);
    solver.analyse(system.pattern);
    const double needed = solver.predicted_bytes();
    CHECK(needed >= 8.0 * static_cast<double>(solver.factor_nonzeros()));

    MultifrontalSolver refused(2);
    refused.set_memory_limit(0.99 * needed);
    try {
        refused.analyse(system.pattern);
        FAIL("it was not refused");
    } catch (const InsufficientMemory& refusal) {
        CHECK(refusal.needed() == needed);
        CHECK(refusal.available() == 0.99 * needed);
    }
    refused.set_memory_limit(needed);
    refused.analyse(system.pattern);
    CHECK(refused.factorize(system.K).is_complete);
}

TEST_CASE("There is memory on this machine")
{
    CHECK(available_memory() > 1e6);
    CHECK(available_memory() > 0.0);
}
