#pragma once

#include <array>
#include <variant>
#include <vector>

#include "topology/geometry/flat_point.h"

namespace topology {

/// From one parameter of a curve to another, forwards or backwards.
struct Span {
    double from = 0.0, to = 1.0;

    double middle() const { return 0.5 * (from + to); }
    double at(double share) const { return from + share * (to - from); }
    friend bool operator==(const Span&, const Span&) = default;
};

/// A straight line: a + t (b - a).
struct Segment {
    FlatPoint a, b;
};

/// Part of an ellipse, or of a circle where p and q are equally long and square to each other:
/// center + cos(w) p + sin(w) q, with w from `start`, and as far as `sweep` goes, in radians; counter-clockwise where
/// sweep is positive and p x q is.
struct EllipticArc {
    FlatPoint center;
    FlatVector p, q;
    double start = 0.0, sweep = 0.0;

    double angle(double t) const { return start + t * sweep; }
};

/// Bezier's cubic of four control points.
struct CubicBezier {
    std::array<FlatPoint, 4> points;
};

/// A smooth curve in the plane, from t = 0 to t = 1: what a drawing's lines, arcs, ellipses and splines are made of.
class Curve {
public:
    Curve(const Segment& shape) : shape_(shape) {}
    Curve(const EllipticArc& shape) : shape_(shape) {}
    Curve(const CubicBezier& shape) : shape_(shape) {}

    bool is_straight() const { return std::holds_alternative<Segment>(shape_); }
    bool is_circular() const; ///< a circle's, to 1e-12 of its radius
    const Segment* segment() const { return std::get_if<Segment>(&shape_); }
    const EllipticArc* arc() const { return std::get_if<EllipticArc>(&shape_); }
    const CubicBezier* cubic() const { return std::get_if<CubicBezier>(&shape_); }

    FlatPoint at(double t) const;
    FlatVector derivative(double t) const; ///< with respect to t
    FlatVector second_derivative(double t) const;
    double most_bent(Span span) const; ///< what its length does not exceed along the span
    /// Of unit length, the way it leaves the span's beginning; where the derivative is 0 there, a little further on.
    FlatVector direction(Span span) const;

    FlatBox box(Span span) const;   ///< no larger than need be
    double length(Span span) const; ///< to 1e-12 of it
    /// The parameter up to which the span has this share of its length, to 1e-12 of it.
    double at_share(Span span, double share) const;
    double turning(Span span) const; ///< how far its direction turns, either way, in all [rad]
    /// Of what a line from the origin to a point that runs along the span sweeps over, counter-clockwise: the integral
    /// of (r - origin) x dr / 2, so that a closed chain of spans has the sum as its area (Green).
    double area(Span span, const FlatPoint& origin) const;

    /// The parameter of the nearest point.
    double nearest(const FlatPoint& p, Span span = {}) const;
    /// Parameters strictly inside the span, in its order, where y turns from growing to falling or back.
    std::vector<double> turns_of_y(Span span) const;
    /// The parameter at this height. \pre y is monotone along the span and takes that value
    double at_height(double y, Span monotone) const;
    /// The two parameters of its only crossing with itself, ascending; none if there is no such place.
    std::vector<double> self_crossing() const;

private:
    std::variant<Segment, EllipticArc, CubicBezier> shape_;
};

} // namespace topology
