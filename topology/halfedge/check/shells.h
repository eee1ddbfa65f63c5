#pragma once

#include <cstddef>
#include <vector>

#include "topology/halfedge/solid.h"

namespace topology {

/// One closed surface: faces that are connected across edges, or by being the loops of one face.
struct Shell {
    std::vector<FaceId> faces; ///< in the order in which they were made
    Counts counts;
    std::size_t genus = 0; ///< handles: a sphere has none, a torus one
};

/// Found by walking, in the order of their oldest faces. \pre the solid is sound
std::vector<Shell> shells(const Solid& solid);

/// The six numbers of the formula of Euler and Poincare.
struct EulerCounts {
    std::size_t V = 0, E = 0, F = 0;
    std::size_t L = 0; ///< loops, outer ones and rings
    std::size_t S = 0; ///< shells
    std::size_t G = 0; ///< the sum of the shells' genus

    /// V - E + F - (L - F) - 2 (S - G), which is 0 of every sound solid.
    long formula() const;

    friend bool operator==(const EulerCounts&, const EulerCounts&) = default;
};
EulerCounts euler_counts(const Solid& solid);

} // namespace topology
