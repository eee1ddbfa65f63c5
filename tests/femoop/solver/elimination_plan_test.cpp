#include "femoop/solver/elimination_plan.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "femoop/solver/geometric_dissection.h"
#include "femoop/solver/index.h"
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

/// Some blocks of a graph, in the order of their numbers.
struct Part {
    std::vector<std::int32_t> blocks;
    BlockGraph graph;
};

Part part_of(const BlockGraph& whole, std::vector<std::int32_t> blocks)
{
    std::ranges::sort(blocks);
    Part part{.blocks = std::move(blocks), .graph = {}};
    std::vector<std::int32_t> number(whole.n_blocks(), -1);
    for (const std::int32_t block : part.blocks) {
        number[at(block)] = static_cast<std::int32_t>(part.graph.n_blocks());
        part.graph.block_sizes.push_back(whole.block_sizes[at(block)]);
        part.graph.positions.push_back(whole.positions[at(block)]);
    }
    for (std::size_t i = 0; i < whole.n_cliques(); ++i) {
        const std::array pair{number[at(whole.clique(i)[0])], number[at(whole.clique(i)[1])]};
        if (pair[0] >= 0 && pair[1] >= 0) part.graph.add_clique(pair);
    }
    return part;
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

TEST_CASE("Halves of a large structure, which are cut at the same time, are ordered as each is by itself")
{
    const BlockGraph whole = grid(120, 100);
    const Dissection both = geometric_dissection(BlockAdjacency(whole), whole.positions);
    const auto parts_first_half = [](const Dissection::Part& part) { return part.level == 1 && part.is_separator; };
    const std::size_t middle = std::ranges::find_if(both.parts, parts_first_half)->end;
    const std::size_t separator = both.parts.back().first;
    REQUIRE(both.order.size() == whole.n_blocks());
    REQUIRE(middle < separator);
    for (const auto& [first, end] : {std::pair(std::size_t{0}, middle), std::pair(middle, separator)}) {
        const std::span<const std::int32_t> order = std::span(both.order).subspan(first, end - first);
        const Part half = part_of(whole, {order.begin(), order.end()});
        const Dissection alone = geometric_dissection(BlockAdjacency(half.graph), half.graph.positions);
        std::vector<std::int32_t> expected;
        for (const std::int32_t block : alone.order) expected.push_back(half.blocks[at(block)]);
        CHECK(std::ranges::equal(order, expected));
    }
}

TEST_CASE("A matrix without unknowns gets a solver all the same")
{
    CHECK(solver_for(SparseMatrix(0, 0))->factorize(SparseMatrix(0, 0)).is_positive_definite);
}
