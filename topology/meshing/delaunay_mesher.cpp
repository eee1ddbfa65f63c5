#include "topology/meshing/delaunay_mesher.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "topology/geometry/predicates.h"

namespace topology {

namespace {

constexpr double largest_circle = 0.77; // its radius over the edge that is wanted; an equilateral triangle has 0.58
constexpr std::size_t most_smoothed = 200'000; // triangles: of more nobody sees the shapes
constexpr double least_distance = 0.6;         // of a place from others, over the edge that is wanted

double square(double value) { return value * value; }

FlatBox box_of(const MeshDomain& domain)
{
    FlatBox box;
    for (const FlatPoint& node : domain.nodes) box.add(node);
    return box;
}

/// The squared sine of the smallest angle of a triangle; negative where it runs clockwise.
double smallest_angle(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c)
{
    std::array<double, 3> squares{dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)};
    const double area = turn(a, b, c), least = std::min({squares[0], squares[1], squares[2]});
    return area * std::abs(area) * least / (squares[0] * squares[1] * squares[2]);
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

DelaunayMesher::DelaunayMesher(const MeshDomain& domain, DelaunayOptions options)
    : domain_(domain),
      options_(std::move(options)),
      triangles_(box_of(domain), 2 * domain.nodes.size()),
      least_chord_(4.0 * square(std::sin(options_.min_angle * std::numbers::pi / 180.0)))
{
    for (const auto& loop : domain.loops)
        for (std::size_t i = 0; i < loop.size(); ++i) edges_.push_back({loop[i], loop[(i + 1) % loop.size()]});
    edges_.insert(edges_.end(), domain.segments.begin(), domain.segments.end());
    require_apart(edges_);
    std::vector<double> sums(domain.nodes.size()), counts(domain.nodes.size());
    for (const CellEdge& edge : edges_)
        for (const CellNode node : edge) {
            sums[node] += distance(domain.nodes[edge[0]], domain.nodes[edge[1]]);
            counts[node] += 1.0;
        }
    sizes_.assign(Triangulation::n_frame_vertices, 0.0);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        double size = counts[i] > 0.0 ? sums[i] / counts[i] : std::numeric_limits<double>::infinity();
        if (i < options_.sizes.size() && options_.sizes[i] > 0.0) size = std::min(size, options_.sizes[i]);
        sizes_.push_back(limit(size));
    }
}

Triangulation::Index DelaunayMesher::last_point() const { return static_cast<Index>(triangles_.n_vertices() - 1); }

DelaunayMesher::Step DelaunayMesher::next()
{
    if (n_nodes_ < domain_.nodes.size()) {
        insert_node(static_cast<CellNode>(n_nodes_++));
        return Step::Node;
    }
    if (n_edges_ < edges_.size()) {
        fix_edge(edges_[n_edges_++]);
        return Step::Edge;
    }
    if (!is_carved_) {
        find_inside();
        is_carved_ = true;
        return Step::Outside;
    }
    if (insert_point()) return Step::Point;
    if (n_sweeps_ >= options_.n_sweeps || triangles_.n_triangles() > most_smoothed) return Step::Done;
    smooth();
    ++n_sweeps_;
    return Step::Smoothed;
}

CellMesh DelaunayMesher::run(const std::function<bool()>& is_cancelled)
{
    constexpr std::size_t between_looks = 1024;
    for (std::size_t i = 0; next() != Step::Done; ++i)
        if (i % between_looks == 0 && is_cancelled && is_cancelled()) break;
    return mesh();
}

void DelaunayMesher::insert_node(CellNode node)
{
    const FlatPoint& at = domain_.nodes[node];
    const Index start = triangles_.corner_of(last_point()) / 3;
    if (triangles_.cavity(at, start) == nullptr) throw CrossingEdges({node, node}, {node, node});
    triangles_.insert(at);
}

void DelaunayMesher::fix_edge(const CellEdge& edge)
{
    constexpr Index n = Triangulation::n_frame_vertices;
    if (const auto obstacle = triangles_.fix(edge[0] + n, edge[1] + n))
        throw CrossingEdges(edge, {(*obstacle)[0] - n, (*obstacle)[1] - n});
}

/// Triangles that are left of the loops' edges, and those that are reached from them: none at the frame, unless a loop
/// lies outside the one that should be around it.
void DelaunayMesher::find_inside()
{
    constexpr Index n = Triangulation::n_frame_vertices;
    is_inside_.assign(triangles_.n_triangles(), false);
    std::vector<Index> found;
    const auto add = [&](Index triangle) {
        if (is_inside_[triangle]) return;
        is_inside_[triangle] = true;
        found.push_back(triangle);
    };
    const auto is_at_frame = [&](Index triangle) {
        const auto& corners = triangles_.vertices(triangle);
        return std::any_of(corners.begin(), corners.end(), [&](Index vertex) { return triangles_.is_frame(vertex); });
    };
    std::size_t n_of_loops = 0, n_spread = 0;
    for (const auto& loop : domain_.loops) n_of_loops += loop.size();
    for (std::size_t i = 0; i < n_of_loops; ++i) {
        add(*triangles_.triangle_left_of(edges_[i][0] + n, edges_[i][1] + n));
        for (; n_spread < found.size(); ++n_spread) {
            if (is_at_frame(found[n_spread])) throw CrossingEdges(edges_[i], edges_[i]);
            for (Index corner = 3 * found[n_spread]; corner < 3 * found[n_spread] + 3; ++corner)
                if (!triangles_.is_fixed(corner)) add(triangles_.twin(corner) / 3);
        }
    }
    std::sort(found.begin(), found.end());
    for (const Index triangle : found) suspect(triangle);
    const double smallest = *std::min_element(sizes_.begin() + Triangulation::n_frame_vertices, sizes_.end());
    // places that are not nearer than the smallest edges are this many at most
    const double most = 4.0 * domain_.area() / square(smallest) + 100.0 * static_cast<double>(domain_.nodes.size());
    most_points_ = static_cast<std::size_t>(std::min(most, 1e8));
}

bool DelaunayMesher::is_bad(Index triangle) const
{
    const auto& [i, j, k] = triangles_.vertices(triangle);
    const FlatPoint &a = triangles_.at(i), &b = triangles_.at(j), &c = triangles_.at(k);
    const double ab = dot(b - a, b - a), bc = dot(c - b, c - b), ca = dot(a - c, a - c);
    const double radius = ab * bc * ca / (4.0 * square(turn(a, b, c))); // all squared
    const double wanted = (sizes_[i] + sizes_[j] + sizes_[k]) / 3.0;
    if (radius > square(largest_circle * wanted)) return true;
    return std::min({ab, bc, ca}) < least_chord_ * radius; // the smallest angle's chord
}

void DelaunayMesher::suspect(Index triangle)
{
    if (is_bad(triangle)) suspects_.push_back({triangle, triangles_.vertices(triangle)});
}

/// Puts a place into the next triangle that wants one. False when none is left.
bool DelaunayMesher::insert_point()
{
    while (n_looked_ < suspects_.size()) {
        const Suspect next = suspects_[n_looked_++];
        if (triangles_.vertices(next.triangle) != next.vertices) continue;
        if (triangles_.n_vertices() > most_points_ + domain_.nodes.size()) continue;
        const auto& [i, j, k] = next.vertices;
        const FlatPoint centre = circumcentre(triangles_.at(i), triangles_.at(j), triangles_.at(k));
        const double wanted = (sizes_[i] + sizes_[j] + sizes_[k]) / 3.0;
        if (try_at(near_shortest_edge(next.triangle, centre), next.triangle, least_distance * wanted)) return true;
        if (try_at(centre, next.triangle, 0.0)) return true;
    }
    suspects_.clear();
    n_looked_ = 0;
    return false;
}

bool DelaunayMesher::try_at(const FlatPoint& at, Index triangle, double least)
{
    const Triangulation::Cavity* const cavity = triangles_.cavity(at, triangle);
    if (cavity == nullptr || cavity->nearest < square(least) || encroaches(at, *cavity)) return false;
    double size = std::numeric_limits<double>::infinity();
    for (const Index corner : cavity->corners) {
        const Index around = triangles_.vertex(Triangulation::next(corner));
        size = std::min(size, sizes_[around] + options_.growth * distance(triangles_.at(around), at));
    }
    triangles_.insert(at);
    sizes_.push_back(limit(size));
    is_inside_.resize(triangles_.n_triangles(), true);
    for (const Index made : cavity->triangles) suspect(made);
    return true;
}

/// Whether a place lies in the circle over an edge that is fixed.
bool DelaunayMesher::encroaches(const FlatPoint& at, const Triangulation::Cavity& cavity) const
{
    return std::any_of(cavity.corners.begin(), cavity.corners.end(), [&](Index corner) {
        if (!triangles_.is_fixed(corner)) return false;
        const FlatPoint& a = triangles_.at(triangles_.vertex(Triangulation::next(corner)));
        const FlatPoint& b = triangles_.at(triangles_.vertex(Triangulation::previous(corner)));
        return dot(a - at, b - at) < 0.0;
    });
}

/// Where a triangle over the shortest edge is equilateral, as far as sizes differ; no farther than the circumcentre.
FlatPoint DelaunayMesher::near_shortest_edge(Index triangle, const FlatPoint& centre) const
{
    const auto& corners = triangles_.vertices(triangle);
    double shortest = std::numeric_limits<double>::infinity();
    FlatPoint foot;
    double wanted = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Index a = corners[i], b = corners[(i + 1) % 3];
        const double squared = dot(triangles_.at(b) - triangles_.at(a), triangles_.at(b) - triangles_.at(a));
        if (squared >= shortest) continue;
        shortest = squared;
        foot = middle(triangles_.at(a), triangles_.at(b));
        wanted = 0.5 * (sizes_[a] + sizes_[b]);
    }
    const double leg = std::clamp(wanted, std::sqrt(shortest), 2.0 * std::sqrt(shortest));
    const double height = std::sqrt(square(leg) - 0.25 * shortest);
    const double reach = distance(centre, foot);
    return reach <= height ? centre : foot + (height / reach) * (centre - foot);
}

/// The smallest angle of the triangles around a vertex, as `smallest_angle` measures it.
double DelaunayMesher::worst_around(Index vertex) const
{
    double worst = 1.0;
    const Index start = triangles_.corner_of(vertex);
    Index corner = start;
    do {
        const Index b = triangles_.vertex(Triangulation::next(corner)),
                    c = triangles_.vertex(Triangulation::previous(corner));
        worst = std::min(worst, smallest_angle(triangles_.at(vertex), triangles_.at(b), triangles_.at(c)));
        corner = triangles_.turned(corner);
    } while (corner != start);
    return worst;
}

/// Moves each place inside to the middle of its neighbours, where that makes no angle around it smaller than the smallest was.
void DelaunayMesher::smooth()
{
    const auto first = static_cast<Index>(Triangulation::n_frame_vertices + domain_.nodes.size());
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

CellMesh DelaunayMesher::mesh() const
{
    constexpr Index n = Triangulation::n_frame_vertices;
    CellMesh mesh;
    for (Index v = n; v < triangles_.n_vertices(); ++v) mesh.nodes.push_back(triangles_.at(v));
    for (Index t = 0; t < is_inside_.size(); ++t) {
        const auto& [a, b, c] = triangles_.vertices(t);
        if (is_inside_[t]) mesh.cells.emplace_back(a - n, b - n, c - n);
    }
    return mesh;
}

} // namespace topology
