#include "femoop/shape/line3.h"

#include <array>

namespace femoop {

namespace {

constexpr std::array<NaturalPoint, 3> line3_nodes{{{-1.0}, {1.0}, {0.0}}};

} // namespace

Line3::Line3() : Shape({.kind = ShapeKind::Line3, .domain = Domain::Line, .degree = 2, .nodes = line3_nodes}) {}

Shape::Values Line3::values(NaturalPoint p) const
{
    return Eigen::Vector3d(0.5 * p.xi * (p.xi - 1.0), 0.5 * p.xi * (p.xi + 1.0), 1.0 - p.xi * p.xi);
}

Shape::Derivatives Line3::derivatives(NaturalPoint p) const
{
    Derivatives d(3, 2);
    d << p.xi - 0.5, 0.0, //
        p.xi + 0.5, 0.0,  //
        -2.0 * p.xi, 0.0;
    return d;
}

} // namespace femoop
