#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "femoop/analysis/structure.h"
#include "femoop/result/results.h"

namespace femoop::detail {

/// What the results of one load case are read from.
struct CaseSolution {
    std::vector<double> displacements; ///< of every node, model dofs after one another, global axes
    std::vector<NodeVector> reactions; ///< parallel to Structure::supports, global axes
    Equilibrium equilibrium;

    /// Only where constraints took strains from members: what their forces follow from, as small displacements of the
    /// structure made of those members alone with their own stiffness, and the ends of members whose joints are
    /// flexible.
    std::vector<double> constraint_displacements;
    std::vector<double> own_ends;            ///< 12 local end displacements per entry of Solution::own_end_of
    std::vector<double> constraint_own_ends; ///< the same of the constraint displacements
};

struct Solution {
    std::shared_ptr<const Structure> structure;
    std::vector<CaseLoads> loads;
    std::vector<CaseTerms> cases;
    std::vector<CaseSolution> solutions;  ///< of the load cases
    std::vector<std::int32_t> own_end_of; ///< of each member: index into own_ends, or -1; empty when there is none
    Indeterminacy indeterminacy;
    std::vector<Fault> warnings;

    double displacement(std::size_t case_index, NodeId node, Dof dof) const;
};

/// A vector [6] at each end of a member, along and about its own axes.
using EndVectors = std::array<Eigen::Matrix<double, 6, 1>, 2>;

/// Displacements of a member's own two ends, through rigid arms and flexible joints.
EndVectors end_displacements(const Solution& solution, std::size_t case_index, MemberId member);

/// Forces on a member's own two ends: what its nodes do to it.
EndVectors end_forces(const Solution& solution, std::size_t case_index, MemberId member);

} // namespace femoop::detail
