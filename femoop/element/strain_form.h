#pragma once

#include <Eigen/Core>

#include "femoop/element/bar.h"
#include "femoop/element/beam.h"

namespace femoop {

/// A stiffness in terms of strains that do not depend on one another: k = B' S B. A rigid motion strains nothing, so
/// that no stiffness is lost where forces are found from strains instead of from displacements.
///
///      e = B d          bar   e = u2 - u1
///      s = S e          beam  e = (phi1 - psi, phi2 - psi), psi = (v2 - v1) / L;
///                             with a foundation also v1 / L, v2 / L
///
/// Source  natural modes [Przemieniecki1968, sec. 6.6]
struct StrainForm {
    Eigen::MatrixXd B; ///< [strains x displacements]
    Eigen::MatrixXd S; ///< [strains x strains], positive definite
};

StrainForm strain_form(const Bar& bar, double L);
StrainForm strain_form(const Beam& beam, double L, BendingPlane plane); ///< of d = (v1, phi1, v2, phi2)

} // namespace femoop
