#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/solver/solver_kind.h"
#include "femoop/solver/system_pattern.h"

namespace femoop {

/// Which displacements are unknown, and the number of each one's equation, in the order of elimination.
///
/// A node's displacements are counted in the axes of its support. Members whose strains a constraint takes away and
/// whose joints are flexible have ends of their own: one more unknown for each flexible joint. Nodes come first as
/// blocks of the system, then such members; every member is a clique.
class Equations {
public:
    static constexpr std::int32_t none = SystemPattern::none;

    Equations(const Discretisation& structure, SolverKind wanted); ///< in the order that suits the solver

    const SystemPattern& pattern() const { return pattern_; }
    std::size_t n_unknowns() const { return pattern_.n_equations(); }

    /// Of displacement i (in the model's order) of a node; none where a support blocks it or no member meets the node.
    std::int32_t of(NodeId node, std::size_t i) const { return of_node_[node.index * dofs_per_node_ + i]; }

    /// Of a member-end degree of freedom, per local axis; none where the joint is rigid.
    std::int32_t of_member_end(MemberId member, std::size_t end, LocalAxis axis) const;

    /// Index of each member's 12 member-end degrees of freedom, or -1; empty when no member has any.
    const std::vector<std::int32_t>& member_end_dofs_of() const { return member_end_dofs_of_; }
    std::size_t n_member_end_dofs() const { return of_member_end_.size(); }
    std::int32_t member_end(std::size_t i) const { return of_member_end_[i]; }

private:
    std::size_t dofs_per_node_;
    std::vector<std::int32_t> member_end_dofs_of_;
    SystemPattern pattern_;
    std::vector<std::int32_t> of_node_;
    std::vector<std::int32_t> of_member_end_;
};

/// The blocks of a structure's system and which of them its members couple, as `Equations` numbers them.
BlockGraph block_graph(const Discretisation& structure);

/// The displacements of a node that a model counts, in its order.
std::span<const Dof> model_dofs(AnalysisKind kind);

} // namespace femoop
