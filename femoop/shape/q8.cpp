#include "femoop/shape/q8.h"

#include <array>

namespace femoop {

namespace {

constexpr std::array<NaturalPoint, 8> q8_nodes{
    {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}, {0.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}}};
constexpr int q8_edge_nodes[4][3]{{0, 1, 4}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}};
constexpr std::array<Shape::Edge, 4> q8_edges{q8_edge_nodes[0], q8_edge_nodes[1], q8_edge_nodes[2], q8_edge_nodes[3]};

} // namespace

Q8::Q8()
    : Shape({.kind = ShapeKind::Q8,
             .domain = Domain::Quadrilateral,
             .degree = 2,
             .nodes = q8_nodes,
             .edge_kind = ShapeKind::Line3,
             .edges = q8_edges})
{}

Shape::Values Q8::values(NaturalPoint p) const
{
    Values N(8);
    for (int i = 0; i < 8; ++i) {
        const auto [xi_i, eta_i] = nodes()[i];
        const double a = xi_i * p.xi, b = eta_i * p.eta;
        if (xi_i == 0.0) N[i] = 0.5 * (1.0 - p.xi * p.xi) * (1.0 + b);
        else if (eta_i == 0.0) N[i] = 0.5 * (1.0 + a) * (1.0 - p.eta * p.eta);
        else N[i] = 0.25 * (1.0 + a) * (1.0 + b) * (a + b - 1.0);
    }
    return N;
}

Shape::Derivatives Q8::derivatives(NaturalPoint p) const
{
    Derivatives d(8, 2);
    for (int i = 0; i < 8; ++i) {
        const auto [xi_i, eta_i] = nodes()[i];
        const double a = xi_i * p.xi, b = eta_i * p.eta;
        if (xi_i == 0.0) d.row(i) << -p.xi * (1.0 + b), 0.5 * eta_i * (1.0 - p.xi * p.xi);
        else if (eta_i == 0.0) d.row(i) << 0.5 * xi_i * (1.0 - p.eta * p.eta), -p.eta * (1.0 + a);
        else d.row(i) << 0.25 * xi_i * (1.0 + b) * (2.0 * a + b), 0.25 * eta_i * (1.0 + a) * (a + 2.0 * b);
    }
    return d;
}

} // namespace femoop
