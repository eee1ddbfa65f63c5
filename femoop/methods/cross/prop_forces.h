#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "femoop/methods/cross/distribution.h"

namespace femoop::cross {

/// The forces that props hold at the end of sheets, along their directions, as `holding_forces` finds them. A sheet ends
/// with unbalances up to its tolerance, which leave something of a force that the locked structure does not have: where
/// the force is 0 in the limit of all turns, and what is left of it is no more than the tolerance explains, it is 0.
///
///      in the limit    A_tt t = b_t    R = A_st t - b_s     t: rotations of the joints, s: sways
///
/// Units    the model's base units
/// Assumes  what is no more than rounding beside the terms of R is 0
class PropForces {
public:
    /// \pre the problem outlives it
    explicit PropForces(const Problem& problem) : problem_(problem) {}

    /// \param stage  0: the sheet of the loads, else that of sway stage - 1
    std::vector<double> at_end_of(const Sheet& sheet, std::size_t stage);

private:
    /// The joints' equations, which are solved for no more than the forces that may be 0.
    struct Equations {
        Eigen::MatrixXd A;
        Eigen::VectorXd b;
        Eigen::LDLT<Eigen::MatrixXd> of_joints;
    };

    std::vector<bool> vanish_in_limit(std::size_t stage);

    const Problem& problem_;
    std::optional<Equations> equations_;
};

} // namespace femoop::cross
