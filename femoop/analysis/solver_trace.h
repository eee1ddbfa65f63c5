#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/model/model.h"
#include "femoop/solver/block_graph.h"
#include "femoop/solver/ordering.h"
#include "femoop/solver/solver_kind.h"
#include "femoop/solver/trace/elimination_walk.h"

namespace femoop {

/// How a structure's system of equations is eliminated, in the order that the solver takes and in others: what a
/// lesson on sparse solvers shows, and no number of the system itself.
///
/// Where members are inextensible or rigid, the constraints make some unknowns follow others, which the solver then
/// leaves out; the trace is of the system before that.
///
/// Lesson  courseware/02-the-front-walks.md
struct SolverTrace {
    static constexpr std::size_t most_unknowns = 400; ///< of more only the counts are there

    /// What comes and goes together: a node with its unknowns, or a member's member-end degrees of freedom.
    struct Block {
        std::string name;                           ///< of the node, or of the member
        bool is_member = false;                     ///< its unknowns are ends of a member that hang on flexible joints
        std::vector<std::string> unknowns{};        ///< "B.ux" "B.uy" "B.rz", in the order of their equations
        std::optional<std::int32_t> separator{};    ///< level of the separator that dissection puts it in, from 0
        std::int32_t piece = EliminationWalk::none; ///< part of the dissection, in the order of elimination
    };

    AnalysisKind kind = AnalysisKind::Frame2d;
    std::vector<Block> blocks;            ///< nodes in the model's order, then members
    BlockGraph graph;                     ///< of these blocks; its cliques are the members
    bool has_constraints = false;         ///< any inextensible or rigid member
    SolverKind wanted{};                  ///< that was asked for
    SolverKind solver{};                  ///< that factorizes the system
    std::optional<Ordering> ordering;     ///< that it eliminates in; nothing where it is none of the four
    std::array<EliminationWalk, 4> walks; ///< by Ordering; nested dissection is the one in space

    bool has_details() const { return n_unknowns() <= most_unknowns; }
    std::size_t n_unknowns() const { return walks.front().counts.n_unknowns; }
    const EliminationWalk& walk(Ordering order) const { return walks[static_cast<std::size_t>(order)]; }
};

/// \throws ModelError with what `check` finds
SolverTrace trace_solver(const Model& model, SolverKind wanted = SolverKind::Automatic);

} // namespace femoop
