#include "femoop/solver/elimination_plan.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "femoop/solver/symmetric_solver.h"

using namespace femoop;

namespace {

/// Nodes of three unknowns in a rectangle, each joined to the next along and across.
BlockGraph grid(std::int32_t width, std::int32_t height)
{
    BlockGraph graph;
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < width; ++x) {
            const std::int32_t here = y * width + x;
            graph.block_sizes.push_back(3);
            graph.positions.emplace_back(x, y, 0.0);
            if (x > 0) graph.add_clique(std::array{here - 1, here});
            if (y > 0) graph.add_clique(std::array{here - width, here});
        }
    return graph;
}

EliminationPlan plan(SolverKind wanted, const BlockGraph& graph)
{
    return plan_elimination(wanted, graph, BlockAdjacency(graph));
}

} // namespace

TEST_CASE("In the profile of a chain every row reaches back to the block before: n blocks of k take k^3 (n - 1)")
{
    BlockGraph chain;
    chain.block_sizes = {3, 3, 3, 3, 3};
    for (std::int32_t i = 1; i < 5; ++i) chain.add_clique(std::array{i - 1, i});
    CHECK(profile_work(chain, BlockAdjacency(chain), {0, 1, 2, 3, 4}) == 27.0 * 4);
    CHECK(profile_work(chain, BlockAdjacency(chain), {4, 3, 2, 1, 0}) == 27.0 * 4);
    CHECK(profile_work(chain, BlockAdjacency(chain), {0, 2, 1, 4, 3}) == 3.0 * (6 * 6 + 9 * 9));
}

TEST_CASE("Of two structures with as many unknowns the slender one goes to the skyline, the bulky one does not")
{
    CHECK(plan(SolverKind::Automatic, grid(4, 3000)).solver == SolverKind::Skyline);
    const SolverKind bulky = plan(SolverKind::Automatic, grid(100, 120)).solver;
    CHECK(bulky != SolverKind::Skyline);
    CHECK(bulky != SolverKind::Automatic);
}

TEST_CASE("Who names a solver gets it, with every block in its order once")
{
    const BlockGraph graph = grid(6, 7);
    for (const SolverKind kind : available_solvers()) {
        CAPTURE(name(kind));
        EliminationPlan planned = plan(kind, graph);
        if (kind != SolverKind::Automatic) CHECK(planned.solver == kind);
        std::sort(planned.order.begin(), planned.order.end());
        REQUIRE(planned.order.size() == 42);
        for (std::int32_t i = 0; i < 42; ++i) CHECK(planned.order[static_cast<std::size_t>(i)] == i);
    }
}

TEST_CASE("A matrix without unknowns gets a solver all the same")
{
    CHECK(solver_for(SparseMatrix(0, 0))->factorize(SparseMatrix(0, 0)).is_positive_definite);
}
