#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/discretisation/equations.h"

namespace femoop {

/// An unrestrained rotation, which strains nothing because joints let it: of one node, where all members are hinged or
/// can rotate about their own axis, or of the nodes of a chain of members in one line that rotates as a whole.
///
///      A >o------B-------C------o< D      hinged at A and D, B and C turn together about the line
///
/// An artificial stiffness restrains it, so that it makes no false mechanism; a moment on it is one.
struct ArtificialRestraint {
    struct Part {
        NodeId node;
        Dof dof;
        std::int32_t row; ///< its equation
    };
    std::vector<Part> parts;
    Eigen::VectorXd direction; ///< over parts, length 1
    double stiffness = 0.0;    ///< that restrains it
};

/// A member-end degree of freedom of a constrained member that its releases leave free.
struct MemberEndRestraint {
    std::int32_t equation;
    double stiffness; ///< that restrains it
};

/// What is restrained because nothing takes part in it, so that it makes no false mechanism.
struct ArtificialRestraints {
    std::vector<ArtificialRestraint> rotations;
    std::vector<MemberEndRestraint> member_ends;
};

/// Finds the rotations that nothing takes part in, and adds a stiffness to K that restrains them; exact, since K does
/// nothing in their direction. `K` is the lower triangle over all unknowns. Constrained members resist by more than
/// stiffness: then `resistance` tells what takes part (femoop/analysis/compatibility.h), else K does.
std::vector<ArtificialRestraint> restrain_rotations(const Discretisation& structure, const Equations& equations,
                                                    SparseMatrix& K, std::optional<SparseMatrix> resistance);

/// Adds the stiffness of such a rotation. At its first node it is enough: the others cannot turn without it.
template <class Scalar> void add_restraint(const ArtificialRestraint& rotation, Eigen::SparseMatrix<Scalar>& K)
{
    const auto& parts = rotation.parts;
    for (std::size_t i = 0; i < parts.size() && parts[i].node == parts[0].node; ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const auto [upper, lower] = std::minmax(parts[i].row, parts[j].row);
            K.coeffRef(lower, upper) += rotation.stiffness * rotation.direction[static_cast<Eigen::Index>(i)] *
                                        rotation.direction[static_cast<Eigen::Index>(j)];
        }
}

} // namespace femoop
