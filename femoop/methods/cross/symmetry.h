#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/methods/cross/distribution.h"

namespace femoop::cross {

enum class SymmetryKind : std::uint8_t { Symmetric, Antisymmetric };

/// A vertical axis about which the structure is its own mirror image, and a loading its own or the opposite: half of
/// the joints need be balanced.
///
///        A    B  :  C    D        symmetric      M_CB = -M_BC   the member BC takes 2EI/L, nothing is carried over
///        |----o--:--o----|        antisymmetric  M_CB = +M_BC   it takes 6EI/L
///
struct Symmetry {
    SymmetryKind kind = SymmetryKind::Symmetric;
    double x = 0.0;                ///< of the axis
    std::vector<EndId> mirror;     ///< of every end
    std::vector<JointId> balanced; ///< joints left of the axis
    std::vector<EndId> crossing;   ///< their ends whose members cross the axis
};

/// The shortcut that a structure and a loading offer, if any. An antisymmetric one with joints on the axis is left out.
std::optional<Symmetry> symmetry_of(const Model& model, const Problem& problem, const Loading& loading);

/// The half that is balanced: crossing members with 2EI/L or 6EI/L (s - Cs or s + Cs), no other joints.
struct Half {
    Problem problem;
    Loading loading;
};
Half half_of(const Problem& problem, const Loading& loading, const Symmetry& symmetry);

/// Moments at every end from those of the half.
std::vector<double> whole_of(const Symmetry& symmetry, const Problem& half, const std::vector<double>& moments);

} // namespace femoop::cross
