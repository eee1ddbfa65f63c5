#pragma once

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "femoop/solver/system_pattern.h"

namespace femoop_test {

using femoop::BlockGraph;
using femoop::Ordering;
using femoop::SparseMatrix;
using femoop::SystemPattern;

/// A system of blocks of 0 to 4 unknowns coupled by random positive definite elements of two or three blocks, built
/// twice: by SystemPattern, and entry by entry into a dense matrix.
struct RandomSystem {
    SystemPattern pattern;
    SparseMatrix K;
    Eigen::MatrixXd dense; ///< all of it, in the order of the equations

    RandomSystem(unsigned seed, std::size_t n_blocks, std::size_t n_cliques, Ordering ordering)
        : RandomSystem(random_graph(seed, n_blocks, n_cliques), ordering, seed)
    {}

    static BlockGraph random_graph(unsigned seed, std::size_t n_blocks, std::size_t n_cliques)
    {
        std::mt19937 random(seed);
        BlockGraph graph;
        for (std::size_t i = 0; i < n_blocks; ++i) graph.block_sizes.push_back(static_cast<int>(random() % 5));
        for (std::size_t i = 0; i < n_cliques; ++i) {
            std::vector<std::int32_t> blocks;
            for (std::size_t size = 2 + random() % 2; blocks.size() < size;)
                if (const auto block = static_cast<std::int32_t>(random() % n_blocks);
                    std::find(blocks.begin(), blocks.end(), block) == blocks.end())
                    blocks.push_back(block);
            graph.add_clique(blocks);
        }
        return graph;
    }

private:
    RandomSystem(const BlockGraph& graph, Ordering ordering, unsigned seed)
        : pattern(graph, ordering), K(pattern.matrix())
    {
        std::mt19937 random(seed + 1);
        std::uniform_real_distribution<double> uniform(-1.0, 1.0);
        const auto n = static_cast<Eigen::Index>(pattern.n_equations());
        dense = Eigen::MatrixXd::Zero(n, n);
        for (std::size_t clique = 0; clique < graph.n_cliques(); ++clique) {
            std::vector<std::int32_t> equations;
            for (const std::int32_t block : graph.clique(clique)) {
                const auto b = static_cast<std::size_t>(block);
                equations.push_back(SystemPattern::none); // a prescribed displacement in front of each block
                for (int i = 0; i < graph.block_sizes[b]; ++i) equations.push_back(pattern.first_equation(b) + i);
            }
            const auto size = static_cast<Eigen::Index>(equations.size());
            const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return uniform(random); });
            const Eigen::MatrixXd Ke = B * B.transpose();
            pattern.add(K, clique, equations, Ke);
            for (Eigen::Index i = 0; i < size; ++i)
                for (Eigen::Index j = 0; j < size; ++j)
                    if (const std::int32_t a = equations[static_cast<std::size_t>(i)],
                        b = equations[static_cast<std::size_t>(j)];
                        a >= 0 && b >= 0)
                        dense(a, b) += Ke(i, j);
        }
        for (std::int32_t i = 0; i < n; ++i) {
            pattern.add_to_diagonal(K, i, 0.5 + 0.01 * i); // springs, so that blocks in no clique are held too
            dense(i, i) += 0.5 + 0.01 * i;
        }
    }
};

} // namespace femoop_test
