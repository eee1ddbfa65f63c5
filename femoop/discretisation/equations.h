#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/discretisation/elements.h"
#include "femoop/solver/solver_kind.h"
#include "femoop/solver/system_pattern.h"

namespace femoop {

/// Which displacements are unknown, and the number of each one's equation, in the order of elimination.
///
/// A node's displacements are counted in the axes of its support. Elements may have degrees of freedom of their own:
/// those of a member whose strains a constraint takes away and whose joints are flexible, one for each such joint.
/// Nodes come first as blocks of the system, then such elements; every element is a clique.
class Equations {
public:
    static constexpr std::int32_t none = SystemPattern::none;

    /// In the order that suits the solver.
    Equations(const Discretisation& structure, const Elements& elements, SolverKind wanted);

    const SystemPattern& pattern() const { return pattern_; }
    std::size_t n_unknowns() const { return pattern_.n_equations(); }

    /// Of displacement i (in the model's order) of a node; none where a support blocks it or no member meets the node.
    std::int32_t of(NodeId node, std::size_t i) const { return of_node_[node.index * dofs_per_node_ + i]; }

    /// Of an element's degrees of freedom, in its order.
    std::span<const std::int32_t> of_element(std::size_t element) const
    {
        return std::span(of_elements_)
            .subspan(element_start_[element], element_start_[element + 1] - element_start_[element]);
    }

    /// Of a member-end degree of freedom, per local axis; none where the joint is rigid.
    std::int32_t of_member_end(MemberId member, std::size_t end, LocalAxis axis) const;

    /// Index of each member's 12 member-end degrees of freedom, or -1; empty when no member has any.
    const std::vector<std::int32_t>& member_end_dofs_of() const { return member_end_dofs_of_; }
    std::size_t n_member_end_dofs() const { return of_member_end_.size(); }
    std::int32_t member_end(std::size_t i) const { return of_member_end_[i]; }

private:
    void number_nodes(const Discretisation& structure);
    void number_elements(const Discretisation& structure, const Elements& elements);
    void number_member_ends(const Discretisation& structure);

    std::size_t dofs_per_node_;
    std::vector<std::int32_t> member_end_dofs_of_;
    SystemPattern pattern_;
    std::vector<std::int32_t> of_node_;
    std::vector<std::int32_t> of_elements_; ///< of all elements, one after the other
    std::vector<std::uint32_t> element_start_;
    std::vector<std::int32_t> of_member_end_;
};

/// Have two structures the same equations, whatever the numbers in them? Then the same displacements are unknown and
/// the same ones coupled. Never so with constraints: which unknowns follow others depends on where nodes lie.
bool have_same_equations(const Discretisation& a, const Discretisation& b);

/// The blocks of a structure's system and which of them its elements couple, as `Equations` numbers them.
BlockGraph block_graph(const Discretisation& structure, const Elements& elements);

} // namespace femoop
