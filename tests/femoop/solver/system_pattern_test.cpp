#include "femoop/solver/system_pattern.h"

#include <doctest/doctest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>

#include "femoop/solver/geometric_dissection.h"
#include "tests/femoop/solver/random_system.h"

using namespace femoop;
using femoop_test::RandomSystem;

namespace {

constexpr Ordering orderings[] = {Ordering::Natural, Ordering::CuthillMcKee, Ordering::MinimumDegree,
                                  Ordering::NestedDissection};

/// Nodes of a grid, each coupled to its right and upper neighbour.
BlockGraph grid(std::int32_t columns, std::int32_t rows, std::int32_t block_size)
{
    BlockGraph graph;
    graph.block_sizes.assign(static_cast<std::size_t>(columns * rows), block_size);
    for (std::int32_t y = 0; y < rows; ++y)
        for (std::int32_t x = 0; x < columns; ++x) {
            const std::int32_t node = y * columns + x;
            if (x + 1 < columns) graph.add_clique(std::array{node, node + 1});
            if (y + 1 < rows) graph.add_clique(std::array{node, node + columns});
        }
    return graph;
}

/// Entries of L with diagonal when blocks are eliminated in this order, counted on a dense pattern.
std::size_t fill(const BlockGraph& graph, const std::vector<std::int32_t>& order)
{
    const BlockAdjacency adjacency(graph);
    const std::size_t n = order.size();
    std::vector<std::size_t> position(n);
    for (std::size_t i = 0; i < n; ++i) position[static_cast<std::size_t>(order[i])] = i;
    std::vector<std::vector<bool>> L(n, std::vector<bool>(n, false));
    for (std::int32_t a = 0; a < static_cast<std::int32_t>(n); ++a)
        for (const std::int32_t b : adjacency.of(a))
            L[std::max(position[static_cast<std::size_t>(a)], position[static_cast<std::size_t>(b)])]
             [std::min(position[static_cast<std::size_t>(a)], position[static_cast<std::size_t>(b)])] = true;
    std::size_t count = n;
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = k + 1; i < n; ++i) {
            if (!L[i][k]) continue;
            ++count;
            for (std::size_t j = k + 1; j < i; ++j)
                if (L[j][k]) L[i][j] = true;
        }
    return count;
}

} // namespace

TEST_CASE("Element matrices land where their equations say, in every ordering")
{
    for (const Ordering ordering : orderings)
        for (unsigned seed = 1; seed <= 20; ++seed) {
            CAPTURE(static_cast<int>(ordering));
            CAPTURE(seed);
            const RandomSystem system(seed, 17, 23, ordering);
            const Eigen::MatrixXd K = SparseMatrix(system.K.selfadjointView<Eigen::Lower>());
            CHECK((K - system.dense).cwiseAbs().maxCoeff() <= 1e-14 * system.dense.cwiseAbs().maxCoeff());
        }
}

TEST_CASE("The matrix is a lower triangle by columns with rows ascending and the diagonal first")
{
    const RandomSystem system(3, 29, 41, Ordering::MinimumDegree);
    const SparseMatrix& K = system.K;
    for (std::int32_t column = 0; column < K.cols(); ++column) {
        CAPTURE(column);
        const int start = K.outerIndexPtr()[column];
        const int end = K.outerIndexPtr()[column + 1];
        REQUIRE(start < end);
        CHECK(K.innerIndexPtr()[start] == column);
        CHECK(std::adjacent_find(K.innerIndexPtr() + start, K.innerIndexPtr() + end, std::greater_equal<>()) ==
              K.innerIndexPtr() + end);
    }
}

TEST_CASE("Every block is eliminated once and its equations follow each other")
{
    const BlockGraph graph = RandomSystem::random_graph(5, 31, 37);
    for (const Ordering ordering : orderings) {
        CAPTURE(static_cast<int>(ordering));
        const SystemPattern pattern(graph, ordering);
        std::vector<std::int32_t> blocks = pattern.order();
        std::int32_t next = 0;
        for (const std::int32_t block : blocks) {
            CHECK(pattern.first_equation(static_cast<std::size_t>(block)) == next);
            next += graph.block_sizes[static_cast<std::size_t>(block)];
        }
        CHECK(pattern.n_equations() == graph.n_unknowns());
        std::sort(blocks.begin(), blocks.end());
        std::vector<std::int32_t> all(graph.n_blocks());
        std::iota(all.begin(), all.end(), 0);
        CHECK(blocks == all);
    }
}

TEST_CASE("Minimum degree and nested dissection number a postorder of the elimination tree")
{
    const BlockGraph graph = grid(13, 11, 2);
    const BlockAdjacency adjacency(graph);
    for (const Ordering ordering : {Ordering::MinimumDegree, Ordering::NestedDissection}) {
        CAPTURE(static_cast<int>(ordering));
        const std::vector<std::int32_t> order = elimination_order(adjacency, ordering);
        const std::vector<std::int32_t> parent = elimination_tree(adjacency, order);
        // In a postorder the descendants of a position are those just before it.
        std::vector<std::int32_t> descendants(parent.size(), 0);
        for (std::size_t i = 0; i < parent.size(); ++i)
            if (parent[i] >= 0) descendants[static_cast<std::size_t>(parent[i])] += 1 + descendants[i];
        for (std::size_t i = 0; i < parent.size(); ++i) {
            if (parent[i] < 0) continue;
            CHECK(parent[i] > static_cast<std::int32_t>(i));
            CHECK(static_cast<std::int32_t>(i) >= parent[i] - descendants[static_cast<std::size_t>(parent[i])]);
        }
    }
}

TEST_CASE("Minimum degree fills a 13 x 11 grid a third less than numbering row by row")
{
    const BlockGraph graph = grid(13, 11, 1);
    std::vector<std::int32_t> by_rows(graph.n_blocks());
    std::iota(by_rows.begin(), by_rows.end(), 0);
    const auto order = elimination_order(BlockAdjacency(graph), Ordering::MinimumDegree);
    CHECK(3 * fill(graph, order) < 2 * fill(graph, by_rows));
}

TEST_CASE("Reverse Cuthill-McKee finds the chain in a shuffled path")
{
    constexpr std::int32_t n = 47;
    BlockGraph path;
    path.block_sizes.assign(n, 1);
    const auto shuffled = [](std::int32_t i) { return 17 * i % n; };
    for (std::int32_t i = 0; i + 1 < n; ++i) path.add_clique(std::array{shuffled(i), shuffled(i + 1)});
    const SystemPattern pattern(path, Ordering::CuthillMcKee);
    for (std::int32_t i = 0; i + 1 < n; ++i)
        CHECK(std::abs(pattern.first_equation(static_cast<std::size_t>(shuffled(i))) -
                       pattern.first_equation(static_cast<std::size_t>(shuffled(i + 1)))) == 1);
}

TEST_CASE("Two members side by side make one pair of places, filled twice")
{
    BlockGraph graph;
    graph.block_sizes = {2, 3};
    graph.add_clique(std::array{0, 1});
    graph.add_clique(std::array{1, 0});
    CHECK(SystemPattern(graph, Ordering::MinimumDegree).n_nonzeros() == 3 + 6 + 2 * 3);
}

TEST_CASE("An equation outside the element's blocks is refused")
{
    BlockGraph graph;
    graph.block_sizes = {2, 3, 1};
    graph.add_clique(std::array{0, 1});
    const SystemPattern pattern(graph, Ordering::MinimumDegree);
    SparseMatrix K = pattern.matrix();
    const std::int32_t foreign = pattern.first_equation(2);
    CHECK_THROWS_AS(pattern.add(K, 0, std::span(&foreign, 1), Eigen::Matrix<double, 1, 1>(3.0)), std::invalid_argument);
}

TEST_CASE("Dissection in space costs a plane grid of 60 x 40 less than minimum degree")
{
    const BlockGraph graph = grid(60, 40, 3);
    const BlockAdjacency adjacency(graph);
    std::vector<Eigen::Vector3d> positions;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) positions.emplace_back(6.0 * x, 0.3 * y, 0.0);
    const auto in_space = elimination_order(adjacency, Ordering::NestedDissection, positions);
    const auto by_degree = elimination_order(adjacency, Ordering::MinimumDegree);
    CHECK(elimination_cost(adjacency, in_space) < 0.9 * elimination_cost(adjacency, by_degree));
}

TEST_CASE("Positions that say nothing about the joints do no harm")
{
    const BlockGraph graph = grid(60, 40, 3);
    const BlockAdjacency adjacency(graph);
    std::mt19937 random(5);
    std::vector<Eigen::Vector3d> positions;
    for (std::size_t i = 0; i < graph.n_blocks(); ++i)
        positions.emplace_back(static_cast<double>(random() % 1000), static_cast<double>(random() % 1000), 0.0);
    const auto misled = elimination_order(adjacency, Ordering::NestedDissection, positions);
    const auto by_degree = elimination_order(adjacency, Ordering::MinimumDegree);
    CHECK(elimination_cost(adjacency, misled) <= elimination_cost(adjacency, by_degree));

    const std::vector<Eigen::Vector3d> one_place(graph.n_blocks(), Eigen::Vector3d(1.0, 2.0, 3.0));
    const auto lost = elimination_order(adjacency, Ordering::NestedDissection, one_place);
    CHECK(elimination_cost(adjacency, lost) <= elimination_cost(adjacency, by_degree));
}

TEST_CASE("A tower of 500 storeys is peeled from its ends, not dissected")
{
    const BlockGraph graph = grid(3, 500, 6);
    const BlockAdjacency adjacency(graph);
    std::vector<Eigen::Vector3d> positions;
    for (int y = 0; y < 500; ++y)
        for (int x = 0; x < 3; ++x) positions.emplace_back(4.0 * x, 3.0 * y, 0.0);
    const auto in_space = elimination_order(adjacency, Ordering::NestedDissection, positions);
    const auto by_degree = elimination_order(adjacency, Ordering::MinimumDegree);
    CHECK(elimination_cost(adjacency, in_space) <= elimination_cost(adjacency, by_degree));
}

TEST_CASE(
    "A tower of 6 by 4 by 40 in space costs no more than by minimum degree, which beats dissection there by a third")
{
    BlockGraph graph;
    std::vector<Eigen::Vector3d> positions;
    for (int z = 0; z < 40; ++z)
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 6; ++x) {
                const std::int32_t here = (z * 4 + y) * 6 + x;
                graph.block_sizes.push_back(6);
                positions.emplace_back(5.0 * x, 6.0 * y, 3.0 * z);
                if (x > 0) graph.add_clique(std::array{here - 1, here});
                if (y > 0) graph.add_clique(std::array{here - 6, here});
                if (z > 0) graph.add_clique(std::array{here - 24, here});
            }
    const BlockAdjacency adjacency(graph);
    const double by_degree = elimination_cost(adjacency, elimination_order(adjacency, Ordering::MinimumDegree));
    CHECK(elimination_cost(adjacency, geometric_dissection(adjacency, positions).order) > by_degree / 0.67);
    CHECK(elimination_cost(adjacency, elimination_order(adjacency, Ordering::NestedDissection, positions)) <=
          by_degree);
}

TEST_CASE("The cost of elimination is the sum of squares of the columns' entries")
{
    const BlockGraph graph = grid(5, 4, 1);
    const BlockAdjacency adjacency(graph);
    const auto order = elimination_order(adjacency, Ordering::MinimumDegree);
    const std::size_t n = order.size();
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(20, 20);
    for (std::size_t i = 0; i < n; ++i) {
        K(static_cast<int>(i), static_cast<int>(i)) = 7.0;
        for (std::size_t j = 0; j < n; ++j)
            for (const std::int32_t neighbour : adjacency.of(order[i]))
                if (neighbour == order[j]) K(static_cast<int>(i), static_cast<int>(j)) = -1.0;
    }
    const Eigen::MatrixXd L = K.llt().matrixL();
    double squares = 0.0;
    for (const auto& column : L.colwise()) squares += std::pow((column.array() != 0.0).count(), 2);
    CHECK(elimination_cost(adjacency, order) == squares);
}
