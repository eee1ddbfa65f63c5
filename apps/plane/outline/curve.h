#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <numbers>
#include <variant>
#include <vector>

#include "femoop/plane/model/drawn_curve.h"

namespace outline {

using Place = Eigen::Vector2d;
using Affine = Eigen::Affine2d;

/// Straight parts one after the other.
struct Polyline {
    std::vector<Place> places;
    bool is_closed = false;
};

/// The places center + u cos t + v sin t from one t to another, backwards where that is less: of a circle, or of an
/// ellipse of which u and v are conjugate half diameters.
struct EllipticArc {
    Place center, u, v;
    double from = 0.0, to = 2.0 * std::numbers::pi;
};

/// Cubic pieces one after the other: 3 k + 1 places.
struct CubicChain {
    std::vector<Place> places;
};

/// A natural spline through its places.
struct SplineThrough {
    std::vector<Place> places;
    bool is_closed = false;
};

/// A curve as files of other programs draw it, of which any affine map is one again.
using Curve = std::variant<Polyline, EllipticArc, CubicChain, SplineThrough>;

/// A quadratic piece as a cubic one.
std::array<Place, 4> raised(const std::array<Place, 3>& quadratic);

Curve mapped(const Curve& curve, const Affine& map);

/// How Cremona draws it; nothing of a curve without length. Lines that are closed by a place of their own are closed.
std::vector<femoop::plane::DrawnShape> shapes_of(const Curve& curve);

} // namespace outline
