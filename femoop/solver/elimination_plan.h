#pragma once

#include <cstdint>
#include <vector>

#include "femoop/solver/block_graph.h"
#include "femoop/solver/ordering.h"
#include "femoop/solver/solver_kind.h"

namespace femoop {

/// Which solver factorizes a system, and in which order it eliminates.
struct EliminationPlan {
    SolverKind solver = SolverKind::Skyline; ///< never Automatic
    std::vector<std::int32_t> order;         ///< blocks in the order of elimination
    Ordering ordering = Ordering::Natural;   ///< which it is; of nested dissection a postorder
};

/// The solver that is wanted with the order that suits it; where it is Automatic, whichever solves the system fastest.
/// What decides is the work within the profile: courseware/decisions/0009-the-profile-decides.md
EliminationPlan plan_elimination(SolverKind wanted, const BlockGraph& graph, const BlockAdjacency& adjacency);

/// Multiplications that L D L' takes within the profile, when blocks are eliminated in this order.
double profile_work(const BlockGraph& graph, const BlockAdjacency& adjacency, const std::vector<std::int32_t>& order);

} // namespace femoop
