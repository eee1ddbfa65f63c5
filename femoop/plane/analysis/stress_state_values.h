#pragma once

#include <Eigen/Core>

#include "femoop/plane/model/plane_expected.h"

namespace femoop::plane {

/// Stress at a point, tension positive; txy acts along +y on the face +x. sz is 0 in plane stress.
struct PlaneStress {
    double sx = 0.0, sy = 0.0, sz = 0.0, txy = 0.0;
};

/// Strain at a point, that of heat too; gxy is the whole angle.
struct PlaneStrain {
    double ex = 0.0, ey = 0.0, ez = 0.0, gxy = 0.0;
};

/// The principal stresses in the plane, s1 >= s2, and the angle from x to s1 [rad], in (-pi/2, pi/2].
struct PrincipalStress {
    double s1 = 0.0, s2 = 0.0, angle = 0.0;
};
PrincipalStress principal(const PlaneStress& stress);
double von_mises(const PlaneStress& stress);
double tresca(const PlaneStress& stress); ///< of all three principal stresses

/// A component of the stress at a place; radial ones about `about`.
double component(const PlaneStress& stress, PlaneComponent which, const Eigen::Vector2d& at,
                 const Eigen::Vector2d& about);
double component(const PlaneStrain& strain, PlaneComponent which);
/// A component of a displacement at a place: ux uy, or ur ut about `about`.
double component(const Eigen::Vector2d& displacement, PlaneComponent which, const Eigen::Vector2d& at,
                 const Eigen::Vector2d& about);

} // namespace femoop::plane
