#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/analysis/unrestrained_rotation.h"

namespace femoop {

inline constexpr double uncoupled = 1e-7; ///< of a radian: a member that moves less stays where it is

/// The members coupled to a node's rotation, which it takes along when it turns: those joined to it rigidly or by a
/// spring, and those at a rigid arm.
///
///      A o== ==B-------C      all of AB's forces are released at A: B may turn free of strain, but swings AB
///
/// A member that only twists about its own axis while its other end is held does not count.
class CoupledMembers {
public:
    explicit CoupledMembers(const Discretisation& structure) : structure_(structure) {}

    /// How the members' ends move, a row each, by unit rotations of the nodes, a column per part. Displacements are
    /// counted in lengths of the member.
    Eigen::MatrixXd motion(const std::vector<ArtificialRestraint::Part>& parts);

private:
    const std::vector<std::vector<MemberId>>& members_of_nodes();

    const Discretisation& structure_;
    std::vector<std::vector<MemberId>> members_of_; ///< of each node; listed when first asked for
};

} // namespace femoop
