#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "femoop/methods/mohr/plane_state.h"

namespace femoop::mohr {

/// A symmetric tensor in space by its components in x, y, z: a stress, or a strain with xy = gamma_xy / 2 ...
/// Signs and units as of PlaneState; xy acts on the face +x along +y, yz on +y along +z, zx on +z along +x.
struct SpaceState {
    double x = 0.0, y = 0.0, z = 0.0, xy = 0.0, yz = 0.0, zx = 0.0;

    friend bool operator==(const SpaceState&, const SpaceState&) = default;
};

Eigen::Matrix3d tensor(const SpaceState& state);
SpaceState from_tensor(const Eigen::Matrix3d& tensor);
/// The plane's components with z = `third` square to it.
SpaceState in_space(const PlaneState& plane, double third);

struct SpacePrincipal {
    std::array<double, 3> values{}; ///< descending
    /// Columns: unit vectors along the first, second and third direction, right-handed, the largest component of the
    /// first two positive. Where values are equal the choice among their directions is free.
    Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();
};

/// By Jacobi's rotations: exact for diagonal tensors, and repeated values give orthonormal directions too.
/// Accuracy  a few roundings of the largest component
/// Source    [GolubVanLoan], Jacobi methods for the symmetric eigenvalue problem
SpacePrincipal principal(const SpaceState& state);

/// Principal values along directions make a state; the values may come in any order.
SpaceState from_principal(const SpacePrincipal& principal);

/// Turned so that one of the directions (0, 1, 2) lies along a vector, and the next one as near as it can to where it
/// was. \pre `along` is finite and not zero; its length does not matter
SpacePrincipal with_direction(const SpacePrincipal& principal, int direction, const Eigen::Vector3d& along);

/// The three circles by their centres and radii: between the first and the third value (the largest), the first and the
/// second, the second and the third.
std::array<Circle, 3> circles(const SpacePrincipal& principal);

double absolute_largest_shear(const SpacePrincipal& principal); ///< (first - third) / 2

struct Invariants {
    double I1 = 0.0, I2 = 0.0, I3 = 0.0; ///< sum, sum of the principal minors, determinant
};
Invariants invariants(const SpaceState& state);

/// What shape the tensor has once its mean is taken away.
struct Deviator {
    double mean = 0.0;             ///< I1 / 3; the octahedral normal component
    std::array<double, 3> values;  ///< principal values less the mean
    double J2 = 0.0, J3 = 0.0;     ///< second (as half the sum of squares) and third invariant of the deviator
    double octahedral_shear = 0.0; ///< sqrt(2 J2 / 3)
    double equivalent = 0.0;       ///< sqrt(3 J2): of a stress, von Mises'
    /// cos 3t = 3 sqrt(3) J3 / 2 J2^(3/2), in [0, pi/3]: 0 in axial tension, pi/3 in axial compression, pi/6 in pure
    /// shear; absent where the deviator is 0.
    std::optional<double> lode{};
};
/// Source  [ChenHan1988], stress invariants
Deviator deviator(const SpacePrincipal& principal);

/// What acts on a plane.
struct OnPlane {
    Eigen::Vector3d normal, traction;                 ///< unit outward normal; the vector tensor * normal
    double normal_component = 0.0;                    ///< along the normal, tension positive
    double shear = 0.0;                               ///< size of what lies in the plane
    std::optional<Eigen::Vector3d> shear_direction{}; ///< unit vector in the plane; absent where shear is 0
};
/// \pre `normal` is finite and not zero; its length does not matter
OnPlane on_plane(const SpaceState& state, const Eigen::Vector3d& normal);

} // namespace femoop::mohr
