#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

namespace femoop::mohr {

/// A symmetric plane tensor by its components in the axes x, y: a stress, a strain or a second moment of area.
///
///          y        ^ y           On the face whose outward normal is +x act x and xy, on the face +y act y and xy.
///          ^   xy -->             Rows and columns of the tensor: [x xy; xy y].
///      +-------+  ^
///      |       |  | xy            stress   x, y tension positive; xy positive along +y on the face +x
///      |       | -----> x         strain   x, y elongation positive; xy = gamma_xy / 2, half the loss of the
///      +-------+                           right angle
///                                 inertia  x = Ix = int y^2 dA, y = Iy = int x^2 dA, xy = -Ixy = -int x y dA
///
/// Units   any, the same for the three
/// Source  [TimoshenkoGoodier1970], plane stress at a point; [Mohr1882]
struct PlaneState {
    double x = 0.0, y = 0.0, xy = 0.0;

    friend bool operator==(const PlaneState&, const PlaneState&) = default;
};

/// The circle of all pairs (normal, shear) on planes through the point; its centre lies on the normal axis.
/// Accuracy  as the components: no squares are taken, so nothing overflows or vanishes that its result does not
struct Circle {
    double centre = 0.0, radius = 0.0;
};
Circle circle(const PlaneState& state);

/// What is largest and least, and the directions.
struct PlanePrincipal {
    double first = 0.0, second = 0.0; ///< first >= second, each with a relative error of a few roundings
    std::optional<double> angle{};    ///< from x to the first direction, counter-clockwise, in (-pi/2, pi/2]; absent
                                      ///< where every direction is principal (a point circle)
};
PlanePrincipal principal(const PlaneState& state);

/// The direction of largest shear: the shear there is +radius in the sense of `xy`. In (-pi/2, pi/2]; absent for a
/// point circle.
std::optional<double> largest_shear_angle(const PlaneState& state);

/// The components in axes turned by `angle` [rad], counter-clockwise positive. Here as in all that follows from a
/// state, what is rounding alone beside the terms that it is the sum of is 0 (rounding.h).
PlaneState rotated(const PlaneState& state, double angle);
/// What is largest and least and the angle of the first direction [rad] make a state.
PlaneState from_principal(double first, double second, double angle);

/// How shear is drawn. In both, a face that turns by an angle moves its point by twice the angle, the same way.
enum class ShearRule : std::uint8_t {
    ClockwiseUp, ///< up where the shear turns the element clockwise: face x is the point (x, -xy), face y is (y, xy)
    TensorDown   ///< the shear's axis points down and counts `xy` in the axes of the face: face x is the point (x, xy)
};

/// A point of the circle's diagram: normal component, and shear as the rule counts it (TensorDown: positive is down).
struct CirclePoint {
    double normal = 0.0, shear = 0.0;
};
/// The point of the face whose outward normal makes `angle` [rad] with x.
CirclePoint face_point(const PlaneState& state, double angle, ShearRule rule);

/// What the lines through the pole are parallel to.
enum class PoleOf : std::uint8_t { Planes, Normals };

/// The pole (origin of planes): the line through it and a point of the circle is parallel to the plane on which that
/// point's components act; for PoleOf::Normals, parallel to the plane's normal.
/// ClockwiseUp: the pole of planes is (x, xy), of normals (y, -xy); TensorDown: the shear has the other sign.
CirclePoint pole(const PlaneState& state, ShearRule rule, PoleOf of = PoleOf::Planes);

Eigen::Matrix2d tensor(const PlaneState& state);

/// An angle taken into (-pi/2, pi/2], the range of a direction without sense [rad].
double as_direction(double angle);

} // namespace femoop::mohr
