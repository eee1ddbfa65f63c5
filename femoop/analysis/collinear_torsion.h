#pragma once

#include <cstddef>
#include <vector>

#include "femoop/analysis/coupled_members.h"
#include "femoop/analysis/unrestrained_rotation.h"

namespace femoop {

inline constexpr double negligible_stiffness = 1e-12; ///< of the stiffness of the members at a node: less is rounding

/// What meets at each node, as far as its rotation is concerned.
struct NodeJoints {
    std::vector<double> stiffness; ///< the largest 4 EI / L of its members
    std::vector<bool> is_flexible; ///< has a member with a release, a spring or a hinge at either end

    /// May some joint have left a rotation of the node unrestrained?
    bool may_turn(std::size_t node) const { return is_flexible[node] && stiffness[node] > 0.0; }
};

/// Collinear torsion mechanisms: members in one line, joined against torsion, that K lets rotate together about that
/// line because of the joints at their ends, and that swing no other member. A line without any release or hinge that
/// its supports alone let rotate is not among them.
std::vector<ArtificialRestraint> collinear_torsion_mechanisms(const Discretisation& structure,
                                                              const Equations& equations, const NodeJoints& joints,
                                                              CoupledMembers& coupled, const SparseMatrix& K);

} // namespace femoop
