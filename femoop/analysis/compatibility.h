#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "femoop/analysis/assembler.h"
#include "femoop/analysis/unrestrained_rotation.h"
#include "femoop/solver/null_modes.h"

namespace femoop {

/// What the displacements of a structure do to its parts, whatever their stiffness:
///
///     e = A x        strains of members, elastic or taken away by a constraint, of springs and of restrained rotations
///     w = B x        swings of members and turns of nodes
///
/// A mechanism turns or swings something and strains nothing. K = A' S A hides that: it squares what A says, and a
/// stiff member's rounding covers a soft one's stiffness.
///
/// Units    angles; lengths are counted in the member's length, of supports in the structure's size
/// Source   [McGuireGallagherZiemian2000, ch. 4-5]
class Compatibility {
public:
    Compatibility(const Assembler& assembler, const ArtificialRestraints& restraints);

    /// The motions [unknowns x motions] that strain nothing, at most so many.
    NullModes free_motions(Eigen::Index most) const;

private:
    using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
    bool is_free(const Eigen::VectorXd& x) const;

    Rows strains_, magnitudes_;   ///< A and |A|
    double largest_strain_ = 0.0; ///< of a unit displacement, prescribed ones too
    Rows turns_;
};

} // namespace femoop
