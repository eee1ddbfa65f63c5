#include "femoop/solver/trace/elimination_walk.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <utility>

#include "femoop/solver/geometric_dissection.h"
#include "femoop/solver/multifrontal/front_tree.h"
#include "tests/femoop/solver/random_system.h"

using namespace femoop;
using femoop_test::RandomSystem;

namespace {

using Order = std::vector<std::int32_t>;

/// Nodes of a grid, each coupled to its right and upper neighbour.
BlockGraph grid(std::int32_t columns, std::int32_t rows, std::int32_t block_size)
{
    BlockGraph graph;
    graph.block_sizes.assign(static_cast<std::size_t>(columns * rows), block_size);
    for (std::int32_t y = 0; y < rows; ++y)
        for (std::int32_t x = 0; x < columns; ++x) {
            const std::int32_t node = y * columns + x;
            graph.positions.emplace_back(x, y, 0.0);
            if (x + 1 < columns) graph.add_clique(std::array{node, node + 1});
            if (y + 1 < rows) graph.add_clique(std::array{node, node + columns});
        }
    return graph;
}

/// Block 0 coupled to every other.
BlockGraph star(std::int32_t n_arms)
{
    BlockGraph graph;
    graph.block_sizes.assign(static_cast<std::size_t>(n_arms) + 1, 1);
    for (std::int32_t arm = 1; arm <= n_arms; ++arm) graph.add_clique(std::array{0, arm});
    return graph;
}

EliminationWalk walk(const BlockGraph& graph, const Order& order, WalkDetail detail = WalkDetail::Pattern)
{
    return walk_elimination(graph, BlockAdjacency(graph), order, detail);
}

EliminationWalk walk(const BlockGraph& graph, Ordering ordering)
{
    return walk(graph, elimination_order(BlockAdjacency(graph), ordering, graph.positions));
}

/// Graphs of many kinds: a chain, a grid, a star, a ring of pieces apart from one another, random ones with blocks of
/// 0 to 4 unknowns.
std::vector<BlockGraph> all_kinds()
{
    std::vector<BlockGraph> graphs{grid(9, 1, 2), grid(5, 4, 3), grid(7, 6, 1), star(6)};
    BlockGraph apart = grid(3, 3, 2);
    for (int i = 0; i < 2; ++i) {
        apart.block_sizes.push_back(5);
        apart.positions.emplace_back(9.0 + i, 2.0, 0.0);
    }
    graphs.push_back(apart);
    for (unsigned seed = 1; seed <= 40; ++seed) {
        BlockGraph graph = RandomSystem::random_graph(seed, 5 + seed % 17, 4 + seed % 23);
        for (std::size_t i = 0; i < graph.n_blocks(); ++i)
            graph.positions.emplace_back(static_cast<double>(i * 7 % 5), static_cast<double>(i * 3 % 4), 0.0);
        graphs.push_back(std::move(graph));
    }
    return graphs;
}

/// Elimination of unknown after unknown on a dense pattern, as one does it with a pencil.
struct ByHand {
    std::vector<std::vector<bool>> L; ///< lower triangle, true where there is an entry
    std::size_t n_entries_of_K = 0, n_entries = 0, n_profile = 0, largest_column = 0;
    double n_operations = 0.0;

    ByHand(const BlockGraph& graph, const Order& order)
    {
        std::vector<std::int32_t> block_of;
        for (const std::int32_t block : order)
            for (std::int32_t i = 0; i < graph.block_sizes[static_cast<std::size_t>(block)]; ++i)
                block_of.push_back(block);
        const std::size_t n = block_of.size();
        L.assign(n, std::vector<bool>(n, false));
        const BlockAdjacency adjacency(graph);
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t i = j; i < n; ++i) {
                const auto beside = adjacency.of(block_of[j]);
                L[i][j] = block_of[i] == block_of[j] || std::ranges::find(beside, block_of[i]) != beside.end();
                n_entries_of_K += L[i][j] ? 1 : 0;
            }
        for (std::size_t i = 0; i < n; ++i) {
            std::size_t first = 0;
            while (!L[i][first]) ++first;
            n_profile += i - first + 1;
        }
        for (std::size_t k = 0; k < n; ++k) {
            std::vector<std::size_t> below;
            for (std::size_t i = k + 1; i < n; ++i)
                if (L[i][k]) below.push_back(i);
            n_operations += static_cast<double>(below.size()); // divisions by the pivot
            for (const std::size_t i : below)
                for (const std::size_t j : below) {
                    if (j > i) continue;
                    L[i][j] = true;
                    ++n_operations;
                }
            n_entries += below.size() + 1;
            largest_column = std::max(largest_column, below.size() + 1);
        }
    }
};

} // namespace

TEST_SUITE("elimination walk")
{
    TEST_CASE("Entries of L, operations and the profile are those of elimination with a pencil, in every order")
    {
        std::size_t which = 0;
        for (const BlockGraph& graph : all_kinds()) {
            CAPTURE(which++);
            for (const Ordering ordering : all_orderings) {
                CAPTURE(name(ordering));
                const Order order = elimination_order(BlockAdjacency(graph), ordering, graph.positions);
                const ByHand hand(graph, order);
                for (const WalkDetail detail : {WalkDetail::Counts, WalkDetail::Pattern}) {
                    const EliminationCounts counts = walk(graph, order, detail).counts;
                    CHECK(counts.n_unknowns == graph.n_unknowns());
                    CHECK(counts.n_entries_of_K == hand.n_entries_of_K);
                    CHECK(counts.n_entries == hand.n_entries);
                    CHECK(counts.n_operations == hand.n_operations);
                    CHECK(counts.n_profile_entries == hand.n_profile);
                    CHECK(counts.largest_front == hand.largest_column);
                }
            }
        }
    }

    TEST_CASE("The pattern of L is the one found with a pencil, and what K lacks of it is called fill-in")
    {
        for (const BlockGraph& graph : all_kinds())
            for (const Ordering ordering : all_orderings) {
                const EliminationWalk walked = walk(graph, ordering);
                const ByHand hand(graph, walked.order);
                std::vector<std::size_t> first{0};
                for (const std::int32_t block : walked.order)
                    first.push_back(first.back() +
                                    static_cast<std::size_t>(graph.block_sizes[static_cast<std::size_t>(block)]));
                std::size_t n_fill = 0;
                for (std::size_t k = 0; k < walked.columns.size(); ++k) {
                    std::size_t n_below = 0;
                    for (const EliminationWalk::Entry& entry : walked.columns[k]) {
                        const auto row = static_cast<std::size_t>(entry.row);
                        CHECK(hand.L[first[row]][first[k]]);
                        n_below += first[row + 1] - first[row];
                        if (entry.is_fill) n_fill += (first[row + 1] - first[row]) * (first[k + 1] - first[k]);
                    }
                    const auto column = std::count_if(hand.L.begin() + static_cast<std::ptrdiff_t>(first[k + 1]),
                                                      hand.L.end(), [&](const auto& row) { return row[first[k]]; });
                    CHECK(n_below == static_cast<std::size_t>(column));
                }
                CHECK(n_fill == walked.counts.n_fill());
            }
    }

    TEST_CASE("The walk eliminates every unknown once, children before parents, and nothing waits at its end")
    {
        for (const BlockGraph& graph : all_kinds())
            for (const Ordering ordering : all_orderings) {
                const EliminationWalk walked = walk(graph, ordering);
                std::size_t n_pivots = 0, n_entries = 0;
                std::int32_t next = 0;
                for (std::size_t f = 0; f < walked.fronts.size(); ++f) {
                    const EliminationWalk::Front& front = walked.fronts[f];
                    CHECK(front.first == std::exchange(next, front.end));
                    n_pivots += front.n_pivots;
                    n_entries += front.n_entries();
                    CHECK((front.parent == EliminationWalk::none) == (front.n_left == 0));
                    if (front.n_left > 0) CHECK(front.parent > static_cast<std::int32_t>(f));
                    for (const std::int32_t child : walked.children_of(static_cast<std::int32_t>(f)))
                        for (const EliminationWalk::Entry& entry :
                             walked.left(walked.fronts[static_cast<std::size_t>(child)]))
                            CHECK(entry.row >= front.first); // the parent is the first that needs it
                }
                CHECK(n_pivots == graph.n_unknowns());
                CHECK(n_entries == walked.counts.n_entries);
                if (!walked.fronts.empty()) CHECK(walked.fronts.back().n_waiting == 0);
            }
    }

    TEST_CASE("A chain numbered from end to end has no fill-in; its elimination tree is a chain too")
    {
        const EliminationWalk walked = walk(grid(8, 1, 3), Ordering::Natural);
        CHECK(walked.counts.n_fill() == 0);
        CHECK(walked.counts.largest_front == 6);
        CHECK(walked.parent == Order{1, 2, 3, 4, 5, 6, 7, -1});
        CHECK(walked.fronts.size() == 7); // the last two nodes go together
        CHECK(walked.counts.n_levels == 7);
        CHECK(walked.counts.most_waiting == 6); // one update matrix of 3 rows
    }

    TEST_CASE("A star fills wholly where its hub goes first, and not at all where it goes last")
    {
        const BlockGraph graph = star(7);
        const EliminationWalk first = walk(graph, {0, 1, 2, 3, 4, 5, 6, 7});
        CHECK(first.counts.n_entries == 8 * 9 / 2);
        CHECK(first.counts.n_fill() == 7 * 6 / 2);
        CHECK(first.fronts.size() == 1);
        const EliminationWalk last = walk(graph, {1, 2, 3, 4, 5, 6, 7, 0});
        CHECK(last.counts.n_fill() == 0);
        CHECK(last.counts.largest_front == 2);
        CHECK(last.counts.n_levels == 2);
    }

    TEST_CASE("On a grid dissection fills less than the rows of nodes one after another, and its tree is lower")
    {
        for (const std::int32_t side : {7, 10, 15}) {
            CAPTURE(side);
            const BlockGraph graph = grid(side, side, 3);
            const EliminationCounts natural = walk(graph, Ordering::Natural).counts;
            const EliminationCounts dissected = walk(graph, Ordering::NestedDissection).counts;
            CHECK(dissected.n_entries <= natural.n_entries);
            CHECK(dissected.n_operations <= natural.n_operations);
            CHECK(2 * dissected.n_levels <= natural.n_levels);
        }
    }

    TEST_CASE("Blocks without unknowns are passed over; where none has any, there is nothing to walk")
    {
        BlockGraph graph = grid(3, 1, 2);
        graph.block_sizes[1] = 0;
        const EliminationWalk walked = walk(graph, Ordering::Natural);
        CHECK(walked.order == Order{0, 2});
        CHECK(walked.counts.n_entries == 6);
        graph.block_sizes = {0, 0, 0};
        CHECK(walk(graph, Ordering::Natural).fronts.empty());
        CHECK(walk(BlockGraph{}, Ordering::Natural).counts.n_entries == 0);
    }

    TEST_CASE("The solver merges fronts: as many unknowns, no fewer entries, no more fronts")
    {
        const BlockGraph graph = grid(9, 8, 3);
        const EliminationWalk walked = walk(graph, Ordering::NestedDissection);
        const SystemPattern pattern(graph, Ordering::NestedDissection);
        const FrontTree tree({.column_start = pattern.column_start(), .rows = pattern.rows()});
        CHECK(tree.fronts().size() <= walked.fronts.size());
        CHECK(tree.n_entries() >= walked.counts.n_entries);
        CHECK(pattern.n_nonzeros() == walked.counts.n_entries_of_K);
    }

    TEST_CASE("The parts of a dissection follow one another, and no coupling joins two pieces of one level")
    {
        const BlockGraph graph = grid(9, 8, 3);
        const BlockAdjacency adjacency(graph);
        const Dissection dissection = geometric_dissection(adjacency, graph.positions);
        std::vector<std::size_t> part_of(graph.n_blocks());
        std::size_t next = 0;
        for (std::size_t p = 0; p < dissection.parts.size(); ++p) {
            const Dissection::Part& part = dissection.parts[p];
            CHECK(part.first == std::exchange(next, part.end));
            for (std::size_t i = part.first; i < part.end; ++i)
                part_of[static_cast<std::size_t>(dissection.order[i])] = p;
        }
        CHECK(next == graph.n_blocks());
        CHECK(dissection.parts.back().level == 0);
        CHECK(dissection.parts.back().is_separator);
        CHECK(dissection.parts.back().end - dissection.parts.back().first == dissection.first_cut);
        for (std::int32_t a = 0; a < static_cast<std::int32_t>(graph.n_blocks()); ++a)
            for (const std::int32_t b : adjacency.of(a)) {
                const auto& p = dissection.parts[part_of[static_cast<std::size_t>(a)]];
                const auto& q = dissection.parts[part_of[static_cast<std::size_t>(b)]];
                if (p.first != q.first) CHECK(p.level != q.level);
            }
    }
}
