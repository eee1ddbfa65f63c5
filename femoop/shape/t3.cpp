#include "femoop/shape/t3.h"

#include <array>

namespace femoop {

namespace {

constexpr std::array<NaturalPoint, 3> t3_nodes{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};
constexpr int t3_edge_nodes[3][2]{{0, 1}, {1, 2}, {2, 0}};
constexpr std::array<Shape::Edge, 3> t3_edges{t3_edge_nodes[0], t3_edge_nodes[1], t3_edge_nodes[2]};

} // namespace

T3::T3()
    : Shape({.kind = ShapeKind::T3,
             .domain = Domain::Triangle,
             .degree = 1,
             .nodes = t3_nodes,
             .edge_kind = ShapeKind::Line2,
             .edges = t3_edges})
{}

Shape::Values T3::values(NaturalPoint p) const { return Eigen::Vector3d(1.0 - p.xi - p.eta, p.xi, p.eta); }

Shape::Derivatives T3::derivatives(NaturalPoint) const
{
    Derivatives d(3, 2);
    d << -1.0, -1.0, //
        1.0, 0.0,    //
        0.0, 1.0;
    return d;
}

} // namespace femoop
