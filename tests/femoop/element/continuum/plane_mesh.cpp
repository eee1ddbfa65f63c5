#include "tests/femoop/element/continuum/plane_mesh.h"

#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>

using namespace femoop;

namespace femoop_test {

namespace {

using Lattice = std::pair<int, int>; ///< half cells

class LatticeNodes {
public:
    LatticeNodes(PlaneMesh& mesh, int nx, int ny) : mesh_(mesh), nx_(nx), ny_(ny) {}

    NodeId at(Lattice place)
    {
        const auto [found, is_new] = nodes_.try_emplace(place, NodeId(mesh_.positions.size()));
        if (is_new) mesh_.positions.emplace_back(0.5 * place.first / nx_, 0.5 * place.second / ny_);
        return found->second;
    }

private:
    PlaneMesh& mesh_;
    int nx_, ny_;
    std::map<Lattice, NodeId> nodes_;
};

int whole(double value) { return static_cast<int>(std::lround(value)); }

/// An element whose natural coordinates become places of the lattice.
void add_element(PlaneMesh& mesh, LatticeNodes& nodes, double x0, double y0, double scale)
{
    std::vector<NodeId>& element = mesh.elements.emplace_back();
    for (const auto [xi, eta] : shape_of(mesh.shape).nodes())
        element.push_back(nodes.at({whole(x0 + scale * xi), whole(y0 + scale * eta)}));
}

std::vector<NodeId> nodes_of(const PlaneMesh& mesh, ElementEdge where)
{
    std::vector<NodeId> nodes;
    for (const int i : shape_of(mesh.shape).edges()[static_cast<std::size_t>(where.edge)])
        nodes.push_back(mesh.elements[where.element][static_cast<std::size_t>(i)]);
    return nodes;
}

/// Puts middle nodes into the middle of their sides, and centres between corners.
void straighten(PlaneMesh& mesh)
{
    const Shape& shape = shape_of(mesh.shape);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        for (int edge = 0; edge < shape.n_corners(); ++edge) {
            const std::vector<NodeId> nodes = nodes_of(mesh, {e, edge});
            if (nodes.size() < 3) continue;
            mesh.positions[nodes[2].index] = 0.5 * (mesh.positions[nodes[0].index] + mesh.positions[nodes[1].index]);
        }
        for (std::size_t i = 2 * static_cast<std::size_t>(shape.n_corners()); i < mesh.elements[e].size(); ++i) {
            Eigen::Vector2d sum = Eigen::Vector2d::Zero();
            for (std::size_t c = 0; c < 4; ++c) sum += mesh.positions[mesh.elements[e][c].index];
            mesh.positions[mesh.elements[e][i].index] = 0.25 * sum;
        }
    }
}

} // namespace

PlaneMesh unit_square_mesh(ShapeKind shape, int nx, int ny)
{
    PlaneMesh mesh{.shape = shape, .positions = {}, .elements = {}};
    LatticeNodes nodes(mesh, nx, ny);
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            if (shape_of(shape).domain() == Domain::Triangle) {
                add_element(mesh, nodes, 2 * i, 2 * j, 2.0);
                add_element(mesh, nodes, 2 * i + 2, 2 * j + 2, -2.0);
            } else add_element(mesh, nodes, 2 * i + 1, 2 * j + 1, 1.0);
        }
    return mesh;
}

PlaneMesh mapped(PlaneMesh mesh, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& map)
{
    for (Eigen::Vector2d& position : mesh.positions) position = map(position);
    return mesh;
}

PlaneMesh shaken(PlaneMesh mesh, double reach, Sides sides)
{
    const std::vector<bool> stays = is_on_boundary(mesh);
    std::mt19937 random(7); // NOLINT: the same mesh every time
    const auto shift = [&] { return reach * (2.0 * static_cast<double>(random() % 1000) / 999.0 - 1.0); };
    const auto shake = [&](double share) {
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            if (const Eigen::Vector2d by(shift(), shift()); !stays[i]) mesh.positions[i] += share * by;
    };
    shake(1.0);
    straighten(mesh);
    if (sides == Sides::Curved) shake(0.3);
    return mesh;
}

std::vector<ElementEdge> boundary(const PlaneMesh& mesh)
{
    std::map<std::set<NodeId>, std::vector<ElementEdge>> by_ends;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (int edge = 0; edge < shape_of(mesh.shape).n_corners(); ++edge) {
            const std::vector<NodeId> nodes = nodes_of(mesh, {e, edge});
            by_ends[{nodes[0], nodes[1]}].push_back({e, edge});
        }
    std::vector<ElementEdge> alone;
    for (const auto& [ends, edges] : by_ends)
        if (edges.size() == 1) alone.push_back(edges.front());
    return alone;
}

std::vector<bool> is_on_boundary(const PlaneMesh& mesh)
{
    std::vector<bool> is_on(mesh.positions.size(), false);
    for (const ElementEdge edge : boundary(mesh))
        for (const NodeId node : nodes_of(mesh, edge)) is_on[node.index] = true;
    return is_on;
}

std::vector<ShapeKind> plane_shapes()
{
    std::vector<ShapeKind> shapes;
    for (const ShapeKind kind : shape_kinds())
        if (shape_of(kind).edge_kind()) shapes.push_back(kind);
    return shapes;
}

} // namespace femoop_test
