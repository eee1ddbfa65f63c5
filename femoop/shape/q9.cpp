#include "femoop/shape/q9.h"

#include <array>

#include "femoop/shape/line3.h"

namespace femoop {

namespace {

constexpr std::array<NaturalPoint, 9> q9_nodes{
    {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}, {0.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, 0.0}}};
constexpr int q9_edge_nodes[4][3]{{0, 1, 4}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}};
constexpr std::array<Shape::Edge, 4> q9_edges{q9_edge_nodes[0], q9_edge_nodes[1], q9_edge_nodes[2], q9_edge_nodes[3]};

/// Of each node: its functions of xi and of eta, as Line3 numbers them (ends, middle).
constexpr int line_nodes[9][2]{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {1, 2}, {2, 1}, {0, 2}, {2, 2}};

} // namespace

Q9::Q9()
    : Shape({.kind = ShapeKind::Q9,
             .domain = Domain::Quadrilateral,
             .degree = 2,
             .nodes = q9_nodes,
             .edge_kind = ShapeKind::Line3,
             .edges = q9_edges})
{}

Shape::Values Q9::values(NaturalPoint p) const
{
    const Line3 line;
    const Values a = line.values({.xi = p.xi}), b = line.values({.xi = p.eta});
    Values N(9);
    for (int i = 0; i < 9; ++i) N[i] = a[line_nodes[i][0]] * b[line_nodes[i][1]];
    return N;
}

Shape::Derivatives Q9::derivatives(NaturalPoint p) const
{
    const Line3 line;
    const Values a = line.values({.xi = p.xi}), b = line.values({.xi = p.eta});
    const Derivatives da = line.derivatives({.xi = p.xi}), db = line.derivatives({.xi = p.eta});
    Derivatives d(9, 2);
    for (int i = 0; i < 9; ++i) {
        const auto [k, l] = line_nodes[i];
        d.row(i) << da(k, 0) * b[l], a[k] * db(l, 0);
    }
    return d;
}

} // namespace femoop
