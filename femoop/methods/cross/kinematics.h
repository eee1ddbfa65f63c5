#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/discretisation/discretisation.h"

namespace femoop::cross {

/// Ends of a member that stay `elongation` further apart than they were.
struct AxialTie {
    NodeId a, b;
    Eigen::Vector2d direction; ///< unit vector from a to b
    double elongation = 0.0;
};

/// How the nodes of axially rigid members can move.
struct Motion {
    struct Mode {
        NodeId node;               ///< moves by 1 along `direction`; the other modes leave it there
        Eigen::Vector2d direction; ///< an axis of its support
        std::vector<Eigen::Vector2d> displacement;
    };
    std::vector<Mode> modes;
    std::vector<Eigen::Vector2d> imposed; ///< what settlements and elongations impose, nodes of the modes held
    bool is_contradictory = false;        ///< nothing can follow them
};

/// Solves the ties for the motions that they leave, in reduced echelon form, so that each mode has one node to hold.
/// \param is_free      nodes that take part
/// \param settlements  of every node, in its support's axes
Motion motion_of(const Discretisation& structure, const std::vector<bool>& is_free, const std::vector<AxialTie>& ties,
                 const std::vector<Eigen::Vector2d>& settlements);

/// The axes of a node's support as rows.
Eigen::Matrix2d support_axes(const Discretisation& structure, NodeId node);

} // namespace femoop::cross
