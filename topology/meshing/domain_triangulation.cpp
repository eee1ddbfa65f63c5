#include "topology/meshing/domain_triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "topology/geometry/predicates.h"

namespace topology {

namespace {

constexpr std::size_t most_smoothed = 200'000; // triangles: of more nobody sees the shapes

FlatBox box_of_nodes(const MeshDomain& domain)
{
    FlatBox box;
    for (const FlatPoint& node : domain.nodes) box.add(node);
    return box;
}

/// The squared sine of the smallest angle of a triangle; negative where it runs clockwise, or two
/// corners are one place.
double smallest_sine(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c)
{
    const double ab = dot(b - a, b - a), bc = dot(c - b, c - b), ca = dot(a - c, a - c);
    const double area = orientation(a, b, c), least = std::min({ab, bc, ca}); // its sign is exact
    return least > 0.0 ? area * std::abs(area) * least / (ab * bc * ca) : -1.0;
}

/// Of a chain of edges none may lead back to where it starts, or along another one.
void require_apart(const std::vector<CellEdge>& edges)
{
    std::vector<CellEdge> sorted;
    for (const auto& [a, b] : edges) {
        if (a == b) throw CrossingEdges({a, b}, {a, b});
        sorted.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) throw CrossingEdges(*twice, *twice);
}

} // namespace

double MeshDomain::area() const
{
    double twice = 0.0;
    for (const auto& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
            twice += turn(nodes[loop[0]], nodes[loop[i]], nodes[loop[(i + 1) % loop.size()]]);
    return 0.5 * twice;
}

std::vector<CellEdge> MeshDomain::edges() const
{
    std::vector<CellEdge> all;
    for (const auto& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) all.push_back({loop[i], loop[(i + 1) % loop.size()]});
    all.insert(all.end(), segments.begin(), segments.end());
    return all;
}

std::vector<double> MeshDomain::sizes(double size, const std::vector<double>& wanted) const
{
    std::vector<double> sums(nodes.size()), counts(nodes.size());
    for (const CellEdge& edge : edges())
        for (const CellNode node : edge) {
            sums[node] += distance(nodes[edge[0]], nodes[edge[1]]);
            counts[node] += 1.0;
        }
    std::vector<double> all;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        double here = counts[i] > 0.0 ? sums[i] / counts[i] : std::numeric_limits<double>::infinity();
        if (i < wanted.size() && wanted[i] > 0.0) here = std::min(here, wanted[i]);
        all.push_back(size > 0.0 ? std::min(size, here) : here);
    }
    return all;
}

DomainTriangulation::DomainTriangulation(const MeshDomain& domain)
    : domain_(domain),
      triangles_(box_of_nodes(domain), 2 * domain.nodes.size()),
      edges_(domain.edges()),
      n_of_loops_(edges_.size() - domain.segments.size())
{
    require_apart(edges_);
}

std::vector<double> DomainTriangulation::sizes(const MesherOptions& options) const
{
    std::vector<double> all(Triangulation::n_frame_vertices);
    const std::vector<double> of_nodes = domain_.sizes(options.size, options.sizes);
    for (std::size_t i = 0; i < of_nodes.size(); ++i) all.push_back(options.limited(of_nodes[i], domain_.nodes[i]));
    return all;
}

std::size_t DomainTriangulation::most_points(const std::vector<double>& sizes, const MesherOptions& options) const
{
    double smallest = *std::min_element(sizes.begin() + Triangulation::n_frame_vertices, sizes.end());
    if (options.field) smallest = std::min(smallest, options.field->least());
    // places that are not nearer than the smallest edges are this many at most
    const double most = 4.0 * domain_.area() / (smallest * smallest) +
                        100.0 * static_cast<double>(domain_.nodes.size());
    return static_cast<std::size_t>(std::min(most, 1e8));
}

std::optional<MeshStep> DomainTriangulation::next()
{
    if (n_nodes_ < domain_.nodes.size()) {
        insert_node(static_cast<CellNode>(n_nodes_++));
        return MeshStep::Node;
    }
    if (n_edges_ < edges_.size()) {
        fix_edge(edges_[n_edges_++]);
        return MeshStep::Edge;
    }
    if (is_carved_) return std::nullopt;
    find_inside();
    is_carved_ = true;
    return MeshStep::Outside;
}

void DomainTriangulation::insert_node(CellNode node)
{
    const FlatPoint& at = domain_.nodes[node];
    if (triangles_.cavity(at, triangles_.corner_of(last_vertex()) / 3) == nullptr)
        throw CrossingEdges({node, node}, {node, node});
    triangles_.insert(at);
}

void DomainTriangulation::fix_edge(const CellEdge& edge)
{
    if (const auto obstacle = triangles_.fix(vertex(edge[0]), vertex(edge[1])))
        throw CrossingEdges(edge, {node((*obstacle)[0]), node((*obstacle)[1])});
}

bool DomainTriangulation::is_at_frame(Index triangle) const
{
    const auto& corners = triangles_.vertices(triangle);
    return std::any_of(corners.begin(), corners.end(), [&](Index vertex) { return triangles_.is_frame(vertex); });
}

/// Triangles that are left of the loops' edges, and those that are reached from them: none at the frame, unless a loop
/// lies outside the one that should be around it.
void DomainTriangulation::find_inside()
{
    is_inside_.assign(triangles_.n_triangles(), false);
    std::vector<Index> found;
    const auto add = [&](Index triangle) {
        if (is_inside_[triangle]) return;
        is_inside_[triangle] = true;
        found.push_back(triangle);
    };
    std::size_t n_spread = 0;
    for (std::size_t i = 0; i < n_of_loops_; ++i) {
        add(*triangles_.triangle_left_of(vertex(edges_[i][0]), vertex(edges_[i][1])));
        for (; n_spread < found.size(); ++n_spread) {
            if (is_at_frame(found[n_spread])) throw CrossingEdges(edges_[i], edges_[i]);
            for (Index corner = 3 * found[n_spread]; corner < 3 * found[n_spread] + 3; ++corner)
                if (!triangles_.is_fixed(corner)) add(triangles_.twin(corner) / 3);
        }
    }
}

/// The smallest angle of the triangles around a vertex, as `smallest_sine` measures it.
double DomainTriangulation::worst_around(Index vertex) const
{
    double worst = 1.0;
    const Index start = triangles_.corner_of(vertex);
    Index corner = start;
    do {
        const Index b = triangles_.vertex(Triangulation::next(corner)),
                    c = triangles_.vertex(Triangulation::previous(corner));
        worst = std::min(worst, smallest_sine(triangles_.at(vertex), triangles_.at(b), triangles_.at(c)));
        corner = triangles_.turned(corner);
    } while (corner != start);
    return worst;
}

bool DomainTriangulation::is_smoothed() const { return triangles_.n_triangles() <= most_smoothed; }

void DomainTriangulation::smooth(Index first)
{
    for (Index vertex = first; vertex < triangles_.n_vertices(); ++vertex) {
        const FlatPoint before = triangles_.at(vertex);
        FlatVector sum;
        double n = 0.0;
        Index corner = triangles_.corner_of(vertex);
        const Index start = corner;
        do {
            sum = sum + (triangles_.at(triangles_.vertex(Triangulation::next(corner))) - before);
            n += 1.0;
            corner = triangles_.turned(corner);
        } while (corner != start);
        const double worst = worst_around(vertex);
        triangles_.move(vertex, before + (1.0 / n) * sum);
        if (worst_around(vertex) < worst) triangles_.move(vertex, before);
    }
    triangles_.restore();
}

std::vector<FlatPoint> DomainTriangulation::corners(Index triangle) const
{
    const auto& [a, b, c] = triangles_.vertices(triangle);
    return {triangles_.at(a), triangles_.at(b), triangles_.at(c)};
}

std::vector<std::vector<FlatPoint>> DomainTriangulation::cells_around(Index vertex) const
{
    std::vector<std::vector<FlatPoint>> cells;
    const Index start = triangles_.corner_of(vertex);
    Index corner = start;
    do {
        cells.push_back(corners(corner / 3));
        corner = triangles_.turned(corner);
    } while (corner != start);
    return cells;
}

std::array<FlatPoint, 2> DomainTriangulation::last_edge() const
{
    const CellEdge& edge = edges_[n_edges_ - 1];
    return {domain_.nodes[edge[0]], domain_.nodes[edge[1]]};
}

CellMesh DomainTriangulation::mesh() const
{
    CellMesh mesh;
    for (Index v = Triangulation::n_frame_vertices; v < triangles_.n_vertices(); ++v)
        mesh.nodes.push_back(triangles_.at(v));
    for (Index t = 0; t < triangles_.n_triangles(); ++t) {
        if (is_carved_ ? !is_inside_[t] : is_at_frame(t)) continue;
        const auto& [a, b, c] = triangles_.vertices(t);
        mesh.cells.emplace_back(node(a), node(b), node(c));
    }
    return mesh;
}

} // namespace topology
