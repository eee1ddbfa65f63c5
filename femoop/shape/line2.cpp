#include "femoop/shape/line2.h"

#include <array>

namespace femoop {

namespace {

constexpr std::array<NaturalPoint, 2> line2_nodes{{{-1.0}, {1.0}}};

} // namespace

Line2::Line2() : Shape({.kind = ShapeKind::Line2, .domain = Domain::Line, .degree = 1, .nodes = line2_nodes}) {}

Shape::Values Line2::values(NaturalPoint p) const { return Eigen::Vector2d(0.5 * (1.0 - p.xi), 0.5 * (1.0 + p.xi)); }

Shape::Derivatives Line2::derivatives(NaturalPoint) const
{
    Derivatives d(2, 2);
    d << -0.5, 0.0, //
        0.5, 0.0;
    return d;
}

} // namespace femoop
