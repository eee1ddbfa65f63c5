#pragma once

#include <Eigen/Dense>
#include <array>
#include <random>
#include <string_view>
#include <vector>

#include "femoop/solver/index.h"
#include "femoop/solver/system_pattern.h"

namespace femoop_test {

using femoop::at;
using femoop::BlockGraph;
using femoop::Ordering;
using femoop::SparseMatrix;
using femoop::SystemPattern;

inline BlockGraph blocks_of(std::int32_t n, std::int32_t size)
{
    BlockGraph graph;
    graph.block_sizes.assign(at(n), size);
    return graph;
}

inline BlockGraph chain(std::int32_t n, std::int32_t size)
{
    BlockGraph graph = blocks_of(n, size);
    for (std::int32_t i = 1; i < n; ++i) graph.add_clique(std::array{i - 1, i});
    return graph;
}

inline BlockGraph grid(std::int32_t side, std::int32_t size)
{
    BlockGraph graph = blocks_of(side * side, size);
    for (std::int32_t y = 0; y < side; ++y)
        for (std::int32_t x = 0; x < side; ++x) {
            const std::int32_t here = y * side + x;
            graph.positions.emplace_back(x, y, 0.0);
            if (x > 0) graph.add_clique(std::array{here - 1, here});
            if (y > 0) graph.add_clique(std::array{here - side, here});
        }
    return graph;
}

/// Every block joined to the first one alone.
inline BlockGraph star(std::int32_t n, std::int32_t size)
{
    BlockGraph graph = blocks_of(n, size);
    for (std::int32_t i = 1; i < n; ++i) graph.add_clique(std::array{0, i});
    return graph;
}

/// Chains of three, and blocks that nothing is joined to.
inline BlockGraph parts(std::int32_t n, std::int32_t size)
{
    BlockGraph graph = blocks_of(n, size);
    for (std::int32_t i = 1; i < n; ++i)
        if (i % 4 > 1) graph.add_clique(std::array{i - 1, i});
    return graph;
}

/// A chain in which some blocks are joined to all others.
inline BlockGraph chain_with_dense_rows(std::int32_t n, std::int32_t size)
{
    BlockGraph graph = chain(n, size);
    for (const std::int32_t hub : {n / 3, n - 1})
        for (std::int32_t i = 0; i < n; ++i)
            if (i != hub) graph.add_clique(std::array{hub, i});
    return graph;
}

inline BlockGraph whole(std::int32_t n, std::int32_t size)
{
    BlockGraph graph = blocks_of(n, size);
    for (std::int32_t i = 0; i < n; ++i)
        for (std::int32_t j = 0; j < i; ++j) graph.add_clique(std::array{j, i});
    return graph;
}

/// Systems of every sparsity that a structure may have.
struct GraphKind {
    std::string_view name;
    BlockGraph (*make)(std::int32_t n, std::int32_t block_size);
    std::int32_t n;
};
inline constexpr std::array<GraphKind, 7> graph_kinds{{{"chain", &chain, 50},
                                                       {"grid", &grid, 9},
                                                       {"star", &star, 40},
                                                       {"parts", &parts, 30},
                                                       {"dense rows", &chain_with_dense_rows, 40},
                                                       {"whole", &whole, 10},
                                                       {"one block", &chain, 1}}};

inline constexpr std::array orderings{Ordering::CuthillMcKee, Ordering::MinimumDegree, Ordering::NestedDissection};

enum class Definiteness { Positive, Indefinite };

/// A system of random elements: positive definite, or with eigenvalues of both signs.
struct GraphSystem {
    SystemPattern pattern;
    SparseMatrix K;

    GraphSystem(const BlockGraph& graph, Ordering ordering, unsigned seed,
                Definiteness definiteness = Definiteness::Positive)
        : pattern(graph, ordering), K(pattern.matrix())
    {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> uniform(-1.0, 1.0);
        for (std::size_t c = 0; c < graph.n_cliques(); ++c) {
            std::vector<std::int32_t> equations;
            for (const std::int32_t block : graph.clique(c))
                for (std::int32_t i = 0; i < graph.block_sizes[at(block)]; ++i)
                    equations.push_back(pattern.first_equation(at(block)) + i);
            const auto n = static_cast<Eigen::Index>(equations.size());
            const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return uniform(random); });
            Eigen::MatrixXd Ke = B + B.transpose();
            if (definiteness == Definiteness::Positive) Ke = B * B.transpose();
            pattern.add(K, c, equations, Ke);
        }
        for (std::int32_t i = 0; i < K.cols(); ++i)
            pattern.add_to_diagonal(K, i, definiteness == Definiteness::Positive ? 0.5 : uniform(random));
    }

    Eigen::MatrixXd load(Eigen::Index columns) const
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> uniform(-1.0, 1.0);
        return Eigen::MatrixXd::NullaryExpr(K.rows(), columns, [&] { return uniform(random); });
    }
    Eigen::MatrixXd dense() const { return Eigen::MatrixXd(K).selfadjointView<Eigen::Lower>(); }
};

inline double residual(const SparseMatrix& K, const Eigen::MatrixXd& X, const Eigen::MatrixXd& B)
{
    return (K.selfadjointView<Eigen::Lower>() * X - B).cwiseAbs().maxCoeff();
}

} // namespace femoop_test
