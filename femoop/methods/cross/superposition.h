#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/methods/cross/distribution.h"

namespace femoop::cross {

/// A sheet and the forces that the props hold at its end.
struct Stage {
    Sheet sheet;
    std::vector<double> holding; ///< of every sway's prop, along its direction (prop_forces.h)
};

/// Sway by superposition: the loads with every sway propped, then each sway alone, then so much of each that no prop
/// holds anything.
///
///      sum over k of  R_jk x_k = -R_j0        R_jk: force at prop j in the sheet of sway k, R_j0: in the loads' sheet
///
/// Without sways it is the one sheet. Each sheet ends at its tolerance; those of the sways are worked on until what is
/// added of them is as exact as the first.
///
/// Signs    moments on the ends of the members, counter-clockwise positive; forces and displacements of a prop along its
///          direction
/// Units    the model's base units, rotations in radians
/// Assumes  members do not change their length
struct Superposition {
    Stage held;
    std::vector<Stage> sways;          ///< parallel to Problem::sways
    Eigen::MatrixXd R;                 ///< R_jk
    Eigen::VectorXd r;                 ///< -R_j0
    Eigen::VectorXd x;                 ///< how many times each sway's sheet is added
    std::vector<double> moments;       ///< at every end
    std::vector<double> rotations;     ///< of every joint [rad]
    std::vector<double> displacements; ///< of every prop along its direction
};

/// \throws ModelError (CrossSteps), MechanismError
Superposition superpose(const Model& model, const Problem& problem, const Procedure& procedure);

} // namespace femoop::cross
