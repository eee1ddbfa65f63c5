#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/methods/cross/problem.h"

namespace femoop::cross {

/// The equations of the slope-deflection method: a moment equation for every joint, then a shear equation (virtual
/// work) for every sway.
///
///      M_AB = FEM_AB + s th_A + C s th_B + (sway moments) D        sum of M at a joint = its load
///
/// Unknowns  rotations of the joints [rad], then displacements D of the props along their directions
/// Source    slope-deflection equations [Maney1915]
struct SlopeDeflection {
    Eigen::MatrixXd A; ///< symmetric
    Eigen::VectorXd b;
    Eigen::VectorXd x;
    std::vector<double> moments; ///< at every end: what the distribution tends to
};

/// The matrix and the right-hand side alone.
SlopeDeflection equations_of(const Problem& problem);

/// \throws MechanismError, ModelError where sways are resisted by nothing
SlopeDeflection slope_deflection(const Model& model, const Problem& problem);

/// Moments at every end for rotations of the joints and displacements of the props, in one vector.
std::vector<double> end_moments(const Problem& problem, const Eigen::VectorXd& unknowns);

/// Says why the structure's equations have no solution: its mechanism, as the analysis tells it.
[[noreturn]] void refuse_mechanism(const Model& model);

} // namespace femoop::cross
