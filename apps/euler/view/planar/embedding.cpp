#include "apps/euler/view/planar/embedding.h"

#include "apps/euler/view/planar/spring_net.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

namespace euler {

using topology::EdgeId;
using topology::HalfEdgeId;
using topology::LoopId;
using topology::Solid;
using topology::VertexId;

namespace {

/// Of n places on the circle, clockwise from the upper left, so that four make an upright square.
ui::Point on_circle(std::size_t i, std::size_t n)
{
    const double angle = std::numbers::pi * (0.5 + (1.0 - 2.0 * static_cast<double>(i)) / static_cast<double>(n));
    return {std::cos(angle), std::sin(angle)};
}

/// The part of a solid that hangs together by edges.
struct Connected {
    std::vector<VertexId> vertices;
    std::vector<EdgeId> edges;
    std::vector<LoopId> loops; ///< the one that it was found from first
};

Connected connected(const Solid& solid, LoopId around)
{
    Connected part;
    std::set<VertexId> seen{solid.start(solid.half_edge(around))};
    std::set<EdgeId> edges;
    std::set<LoopId> loops{around};
    part.vertices.assign(seen.begin(), seen.end());
    part.loops = {around};
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
        for (const HalfEdgeId h : solid.fan(part.vertices[i])) {
            if (seen.insert(solid.end(h)).second) part.vertices.push_back(solid.end(h));
            if (const auto e = solid.edge(h); e && edges.insert(*e).second) part.edges.push_back(*e);
            if (loops.insert(solid.loop(h)).second) part.loops.push_back(solid.loop(h));
        }
    }
    return part;
}

std::vector<VertexId> corners(const Solid& solid, LoopId l)
{
    std::vector<VertexId> vertices;
    for (const HalfEdgeId h : solid.chain(l)) vertices.push_back(solid.start(h));
    return vertices;
}

/// Convex, counter-clockwise, and not squeezed to nothing.
bool is_well_drawn(const std::vector<ui::Point>& polygon)
{
    constexpr double straight = -1e-7, shortest = 1e-4, least_area = 1e-7;
    double area = 0.0;
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        const ui::Point a = polygon[i], b = polygon[(i + 1) % n], c = polygon[(i + 2) % n];
        if (ui::cross(b - a, c - b) < straight || ui::distance(a, b) < shortest) return false;
        area += 0.5 * ui::cross(a, b);
    }
    return area > least_area;
}

/// Of the spring that an edge is: stiffer beside a face of many sides, or their corners, each pulled along the outline
/// by the two beside it and inward by one, would all stand close to it.
double stiffness(std::size_t n_sides)
{
    constexpr double few = 12.0;
    const double times = static_cast<double>(n_sides) / few;
    return std::max(1.0, times * times);
}

/// Straight edges between vertices in the middle of their neighbours, if that draws every face well.
std::optional<Embedding> straight(const Solid& solid, const Connected& part)
{
    const std::vector<VertexId> outline = corners(solid, part.loops.front());
    const bool is_polygon = outline.size() >= 3 && std::set(outline.begin(), outline.end()).size() == outline.size();
    if (!is_polygon) return std::nullopt;
    SpringNet net;
    std::unordered_map<VertexId, std::size_t> node;
    for (std::size_t i = 0; i < outline.size(); ++i) node[outline[i]] = net.add_held(on_circle(i, outline.size()));
    for (const VertexId v : part.vertices)
        if (!node.contains(v)) node[v] = net.add_node();
    std::unordered_map<LoopId, std::size_t> n_sides;
    for (const LoopId l : part.loops) n_sides[l] = corners(solid, l).size();
    n_sides[part.loops.front()] = 0; // its own edges are held
    for (const EdgeId e : part.edges) {
        const HalfEdgeId plus = solid.plus(e), minus = solid.minus(e);
        const std::size_t most = std::max(n_sides[solid.loop(plus)], n_sides[solid.loop(minus)]);
        net.add_spring(node[solid.start(plus)], node[solid.start(minus)], stiffness(most));
    }
    const std::vector<ui::Point> at = at_rest(net);
    Embedding drawn;
    for (const VertexId v : part.vertices) drawn.vertices[v] = at[node[v]];
    for (std::size_t i = 1; i < part.loops.size(); ++i) {
        std::vector<ui::Point> polygon;
        for (const VertexId v : corners(solid, part.loops[i])) polygon.push_back(drawn.vertices[v]);
        if (!is_well_drawn(polygon)) return std::nullopt;
    }
    return drawn;
}

/// Every edge gets two nodes of its own, and every loop a ring of nodes inside its face, three for each half-edge, so
/// that the net is a plane one that no two nodes cut apart, whatever the loops are.
///
///      v ---- m1 ---- m2 ---- w       edge
///      |      |       |       |
///      c ---- d1 ---- d2 ---- c       ring of the loop on its left, all of whose nodes hang on one in the middle
class CurvedDrawing {
public:
    CurvedDrawing(const Solid& solid, const Connected& part) : solid_(solid), part_(part)
    {
        for (const VertexId v : part.vertices) vertices_[v] = net_.add_node();
        for (const EdgeId e : part.edges) add_edge(e);
        for (const LoopId l : part.loops) add_ring(l);
        for (const LoopId l : part.loops) join_ring(l);
    }

    Embedding drawn() const
    {
        const std::vector<ui::Point> at = at_rest(net_);
        Embedding result;
        for (const VertexId v : part_.vertices) result.vertices[v] = at[vertices_.at(v)];
        for (const EdgeId e : part_.edges) {
            const auto [a, b] = middles_.at(e);
            const std::array<ui::Point, 4> through{result.vertices[solid_.start(solid_.plus(e))], at[a], at[b],
                                                   result.vertices[solid_.start(solid_.minus(e))]};
            result.curves[e] = smooth(through);
        }
        return result;
    }

private:
    using Pair = std::array<std::size_t, 2>;
    using Ring = std::array<std::size_t, 3>;

    void add_edge(EdgeId e)
    {
        const Pair middle{net_.add_node(), net_.add_node()};
        middles_[e] = middle;
        net_.add_spring(vertices_[solid_.start(solid_.plus(e))], middle[0]);
        net_.add_spring(middle[0], middle[1]);
        net_.add_spring(middle[1], vertices_[solid_.start(solid_.minus(e))]);
    }

    /// The ring of the loop around is held on the circle.
    void add_ring(LoopId l)
    {
        const std::size_t n = 3 * corners(solid_, l).size();
        std::size_t i = 0;
        for (const HalfEdgeId h : solid_.chain(l))
            for (std::size_t& node : rings_[h])
                node = l == part_.loops.front() ? net_.add_held(on_circle(i++, n)) : net_.add_node();
    }

    void join_ring(LoopId l)
    {
        const bool is_around = l == part_.loops.front();
        const std::size_t middle = is_around ? 0 : net_.add_node();
        for (const HalfEdgeId h : solid_.chain(l)) {
            const Ring& ring = rings_[h];
            const EdgeId e = *solid_.edge(h);
            const bool is_plus = solid_.plus(e) == h;
            net_.add_spring(ring[0], vertices_[solid_.start(h)]);
            net_.add_spring(ring[1], middles_[e][is_plus ? 0 : 1]);
            net_.add_spring(ring[2], middles_[e][is_plus ? 1 : 0]);
            net_.add_spring(ring[0], ring[1]);
            net_.add_spring(ring[1], ring[2]);
            net_.add_spring(ring[2], rings_[solid_.next(h)][0]);
            if (!is_around)
                for (const std::size_t node : ring) net_.add_spring(node, middle);
        }
    }

    /// A curve through four places, a cubic between any two.
    static std::vector<ui::Point> smooth(const std::array<ui::Point, 4>& p)
    {
        constexpr int n = 8;
        std::vector<ui::Point> curve;
        for (std::size_t k = 0; k < 3; ++k) {
            const ui::Point a = k > 0 ? p[k - 1] : 2.0 * p[0] - p[1], d = k < 2 ? p[k + 2] : 2.0 * p[3] - p[2];
            for (int i = 0; i < n; ++i) curve.push_back(between(a, p[k], p[k + 1], d, double{1.0} * i / n));
        }
        curve.push_back(p[3]);
        return curve;
    }
    /// Catmull and Rom's cubic from b to c.
    static ui::Point between(ui::Point a, ui::Point b, ui::Point c, ui::Point d, double t)
    {
        return 0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                      t * t * t * (3.0 * b - a - 3.0 * c + d));
    }

    const Solid& solid_;
    const Connected& part_;
    SpringNet net_;
    std::unordered_map<VertexId, std::size_t> vertices_;
    std::unordered_map<EdgeId, Pair> middles_; ///< as the plus half runs
    std::unordered_map<HalfEdgeId, Ring> rings_;
};

} // namespace

Embedding embedding(const Solid& solid, LoopId around)
{
    const Connected part = connected(solid, around);
    Embedding drawn;
    if (part.edges.empty()) drawn.vertices[part.vertices.front()] = {};
    else if (auto found = straight(solid, part)) drawn = std::move(*found);
    else drawn = CurvedDrawing(solid, part).drawn();
    drawn.loops = part.loops;
    return drawn;
}

} // namespace euler
