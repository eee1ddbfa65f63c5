#include "femoop/shape/t6.h"

#include <array>

namespace femoop {

namespace {

constexpr std::array<NaturalPoint, 6> t6_nodes{
    {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}}};
constexpr int t6_edge_nodes[3][3]{{0, 1, 3}, {1, 2, 4}, {2, 0, 5}};
constexpr std::array<Shape::Edge, 3> t6_edges{t6_edge_nodes[0], t6_edge_nodes[1], t6_edge_nodes[2]};

} // namespace

T6::T6()
    : Shape({.kind = ShapeKind::T6,
             .domain = Domain::Triangle,
             .degree = 2,
             .nodes = t6_nodes,
             .edge_kind = ShapeKind::Line3,
             .edges = t6_edges})
{}

Shape::Values T6::values(NaturalPoint p) const
{
    const double L1 = 1.0 - p.xi - p.eta, L2 = p.xi, L3 = p.eta;
    Values N(6);
    N << L1 * (2.0 * L1 - 1.0), L2 * (2.0 * L2 - 1.0), L3 * (2.0 * L3 - 1.0), //
        4.0 * L1 * L2, 4.0 * L2 * L3, 4.0 * L3 * L1;
    return N;
}

Shape::Derivatives T6::derivatives(NaturalPoint p) const
{
    const double L1 = 1.0 - p.xi - p.eta, L2 = p.xi, L3 = p.eta;
    Derivatives d(6, 2);
    d << 1.0 - 4.0 * L1, 1.0 - 4.0 * L1, //
        4.0 * L2 - 1.0, 0.0,             //
        0.0, 4.0 * L3 - 1.0,             //
        4.0 * (L1 - L2), -4.0 * L2,      //
        4.0 * L3, 4.0 * L2,              //
        -4.0 * L3, 4.0 * (L1 - L3);
    return d;
}

} // namespace femoop
