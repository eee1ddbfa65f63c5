#include "femoop/methods/derivation/renumbering.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include "femoop/solver/trace/elimination_walk.h"

namespace femoop::derivation {

namespace {

using Places = std::vector<std::int32_t>; ///< of each unknown in the matrix

template <class Visit> void each_entry(const SparseMatrix& K, Visit&& visit)
{
    for (Eigen::Index column = 0; column < K.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(K, column); entry; ++entry)
            if (entry.value() != 0.0) visit(static_cast<std::size_t>(entry.row()), static_cast<std::size_t>(column));
}

Places as_counted(std::size_t n)
{
    Places places(n);
    std::iota(places.begin(), places.end(), 0);
    return places;
}

Places inverse(const Places& places)
{
    Places order(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        order[static_cast<std::size_t>(places[i])] = static_cast<std::int32_t>(i);
    return order;
}

/// Every unknown a block of its own.
BlockGraph graph_of(const SparseMatrix& K)
{
    BlockGraph graph;
    graph.block_sizes.assign(static_cast<std::size_t>(K.cols()), 1);
    each_entry(K, [&](std::size_t row, std::size_t column) {
        if (row > column)
            graph.add_clique(std::array{static_cast<std::int32_t>(column), static_cast<std::int32_t>(row)});
    });
    return graph;
}

Reach reach(const SparseMatrix& K, const Places& places)
{
    Places first = as_counted(places.size());
    each_entry(K, [&](std::size_t row, std::size_t column) {
        std::int32_t& least = first[static_cast<std::size_t>(places[row])];
        least = std::min(least, places[column]);
    });
    Reach reach;
    for (std::size_t row = 0; row < first.size(); ++row) {
        const std::size_t length = row + 1 - static_cast<std::size_t>(first[row]);
        reach.half_bandwidth = std::max(reach.half_bandwidth, length);
        reach.profile += length;
    }
    const BlockGraph graph = graph_of(K);
    reach.factor = walk_elimination(graph, BlockAdjacency(graph), inverse(places), WalkDetail::Counts).counts.n_entries;
    return reach;
}

SystemTrace ordered(const SystemTrace& system, const Places& places)
{
    const SparseMatrix K = system.solved_matrix();
    Eigen::MatrixXd f = system.f;
    if (system.ties) f = system.ties->G.transpose() * (system.f - system.K * system.ties->u0);
    Eigen::PermutationMatrix<Eigen::Dynamic> to_order(K.rows());
    SystemTrace other{.unknowns = std::vector<SystemTrace::Unknown>(places.size()), .K = {}, .f = {}};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t unknown = system.ties ? static_cast<std::size_t>(system.ties->independent[i]) : i;
        other.unknowns[static_cast<std::size_t>(places[i])] = system.unknowns[unknown];
        to_order.indices()[static_cast<Eigen::Index>(i)] = places[i];
    }
    other.f = to_order * f;
    other.K = K.selfadjointView<Eigen::Lower>().twistedBy(to_order);
    return other;
}

} // namespace

bool Renumbering::is_same_order() const { return place == as_counted(place.size()); }

bool Renumbering::is_no_gain() const
{
    return given.half_bandwidth == solved.half_bandwidth && given.profile == solved.profile &&
           given.factor == solved.factor;
}

Renumbering renumbering_of(const SystemTrace& system)
{
    const SparseMatrix K = system.solved_matrix();
    return {.given = reach(K, as_counted(system.place.size())),
            .solved = reach(K, system.place),
            .solver = system.solver,
            .ordering = system.ordering,
            .place = system.place};
}

SystemTrace as_given(const SystemTrace& system) { return ordered(system, as_counted(system.place.size())); }

SystemTrace as_eliminated(const SystemTrace& system) { return ordered(system, system.place); }

} // namespace femoop::derivation
