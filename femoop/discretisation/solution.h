#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "femoop/discretisation/case_loads.h"
#include "femoop/discretisation/discretisation.h"
#include "femoop/discretisation/statics.h"
#include "femoop/model/fault/fault.h"
#include "femoop/solver/double_double.h"

namespace femoop::detail {

/// How the nodes of a structure and the ends of its members move.
template <class Scalar> struct Motions {
    std::vector<Scalar> displacements; ///< of every node, model dofs after one another, global axes

    /// Only where constraints took strains from members: what their forces follow from, as small displacements of the
    /// structure made of those members alone with their own stiffness, and the ends of members whose joints are
    /// flexible.
    std::vector<Scalar> constraint_displacements;
    std::vector<Scalar> member_ends; ///< 12 local end displacements per entry of Solution::member_end_dofs_of
    std::vector<Scalar> constraint_member_ends; ///< the same of the constraint displacements
};

/// How well the forces of one load case balance, and what is large or small beside them.
struct Balance {
    double out_of_balance = 0.0; ///< at the worst unknown
    double imposed = 0.0;        ///< largest entry of the load vector, with what settlements and heat bring
    double largest = 0.0;        ///< load or reaction
    double sum_forces = 0.0;     ///< of all loads and reactions, without regard to direction
    double sum_moments = 0.0;    ///< the same, those of the forces about the origin included
    double reach = 0.0;          ///< of the farthest node, from the origin
};

/// What the results of one load case are read from.
struct CaseSolution : Motions<double> {
    std::vector<NodeVector> reactions; ///< parallel to Discretisation::supports, global axes
    Equilibrium equilibrium;
    Balance balance;
    /// To 32 digits, where the members' forces need them: what differs between a member's ends is too small a part of
    /// its displacements. Empty otherwise.
    Motions<DoubleDouble> precise;
    bool is_unstressed = false; ///< it moves, but forces at its members' ends are rounding alone
};

struct Solution {
    std::shared_ptr<const Discretisation> structure;
    std::vector<CaseLoads> loads;
    std::vector<CaseTerms> cases;
    std::vector<CaseSolution> solutions; ///< of the load cases
    std::vector<std::int32_t>
        member_end_dofs_of; ///< of each member: index into member_ends, or -1; empty when there is none
    Indeterminacy indeterminacy;
    std::vector<Fault> warnings;
};

} // namespace femoop::detail
