#include "femoop/shape/q4.h"

#include <array>

namespace femoop {

namespace {

constexpr std::array<NaturalPoint, 4> q4_nodes{{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}};
constexpr int q4_edge_nodes[4][2]{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
constexpr std::array<Shape::Edge, 4> q4_edges{q4_edge_nodes[0], q4_edge_nodes[1], q4_edge_nodes[2], q4_edge_nodes[3]};

} // namespace

Q4::Q4()
    : Shape({.kind = ShapeKind::Q4,
             .domain = Domain::Quadrilateral,
             .degree = 1,
             .nodes = q4_nodes,
             .edge_kind = ShapeKind::Line2,
             .edges = q4_edges})
{}

Shape::Values Q4::values(NaturalPoint p) const
{
    Values N(4);
    for (int i = 0; i < 4; ++i) {
        const auto [xi_i, eta_i] = nodes()[i];
        N[i] = 0.25 * (1.0 + xi_i * p.xi) * (1.0 + eta_i * p.eta);
    }
    return N;
}

Shape::Derivatives Q4::derivatives(NaturalPoint p) const
{
    Derivatives d(4, 2);
    for (int i = 0; i < 4; ++i) {
        const auto [xi_i, eta_i] = nodes()[i];
        d(i, 0) = 0.25 * xi_i * (1.0 + eta_i * p.eta);
        d(i, 1) = 0.25 * eta_i * (1.0 + xi_i * p.xi);
    }
    return d;
}

} // namespace femoop
