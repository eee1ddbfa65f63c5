#include "topology/meshing/triangulation.h"

#include <algorithm>
#include <utility>

#include "topology/geometry/predicates.h"

namespace topology {

namespace {

constexpr double frame_reach = 16.0; // of the box: far enough that no circle of a mesh comes near

bool is_left(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) { return orientation(a, b, c) > 0.0; }

} // namespace

Triangulation::Triangulation(const FlatBox& box, std::size_t n_expected)
{
    points_.reserve(n_expected);
    corners_.reserve(n_expected);
    triangles_.reserve(2 * n_expected);
    const FlatPoint centre = middle(box.low, box.high);
    const double reach = frame_reach * std::max(box.diagonal(), 1e-300);
    points_ = {{centre.x - 2.0 * reach, centre.y - reach},
               {centre.x + 2.0 * reach, centre.y - reach},
               {centre.x, centre.y + 2.0 * reach}};
    triangles_.push_back({.vertices = {0, 1, 2}});
    corners_ = {0, 1, 2};
    fan_.resize(n_frame_vertices);
    seen_.resize(1);
}

void Triangulation::link(Index corner, Index other)
{
    triangles_[corner / 3].twins[corner % 3] = other;
    if (other != none) triangles_[other / 3].twins[other % 3] = corner;
}

/// The triangle that holds the place, found by walking towards it; nothing where edges that are fixed are in the way.
Triangulation::Index Triangulation::locate(const FlatPoint& at, Index start) const
{
    Index t = start, from = none;
    for (std::size_t n_steps = 0; n_steps <= triangles_.size(); ++n_steps) {
        Index across = none;
        bool is_blocked = false;
        for (Index corner = 3 * t; corner < 3 * t + 3; ++corner) {
            if (corner == from || !is_left(points_[vertex(next(corner))], at, points_[vertex(previous(corner))]))
                continue;
            if (twin(corner) == none || is_fixed(corner)) is_blocked = true;
            else across = twin(corner);
            if (across != none) break;
        }
        if (across == none) return is_blocked ? none : t;
        from = across;
        t = across / 3;
    }
    return none;
}

/// Fills the cavity. False where its border cannot be seen from the place.
bool Triangulation::gather(const FlatPoint& at, Index start)
{
    cavity_.triangles.assign(1, start);
    cavity_.corners.clear();
    cavity_.nearest = std::numeric_limits<double>::infinity();
    seen_[start] = ++search_;
    for (std::size_t i = 0; i < cavity_.triangles.size(); ++i) {
        const Index t = cavity_.triangles[i];
        for (Index corner = 3 * t; corner < 3 * t + 3; ++corner) {
            const Index other = twin(corner);
            if (other != none && seen_[other / 3] == search_) continue;
            if (other != none && !is_fixed(corner)) {
                const auto& [a, b, c] = triangles_[other / 3].vertices;
                if (in_circle(points_[a], points_[b], points_[c], at) > 0.0) {
                    seen_[other / 3] = search_;
                    cavity_.triangles.push_back(other / 3);
                    continue;
                }
            }
            cavity_.corners.push_back(corner);
        }
    }
    // an edge put down early may have got a triangle of the cavity behind it
    std::erase_if(cavity_.corners, [&](Index corner) {
        return twin(corner) != none && !is_fixed(corner) && seen_[twin(corner) / 3] == search_;
    });
    for (const Index corner : cavity_.corners) {
        const FlatPoint& a = points_[vertex(next(corner))];
        if (!is_left(at, a, points_[vertex(previous(corner))])) return false;
        cavity_.nearest = std::min(cavity_.nearest, dot(at - a, at - a));
    }
    return true;
}

const Triangulation::Cavity* Triangulation::cavity(const FlatPoint& at, Index start)
{
    const Index t = locate(at, start);
    return t != none && gather(at, t) ? &cavity_ : nullptr;
}

/// One triangle from the new vertex to each edge around the cavity, in its triangles' places first.
Triangulation::Index Triangulation::insert(const FlatPoint& at)
{
    const auto made = static_cast<Index>(points_.size());
    points_.push_back(at);
    fan_.push_back(none);
    struct Border {
        Index start, end, outside;
        bool is_fixed;
    };
    std::vector<Border> border;
    border.reserve(cavity_.corners.size());
    for (const Index corner : cavity_.corners)
        border.push_back({vertex(next(corner)), vertex(previous(corner)), twin(corner), is_fixed(corner)});
    std::vector<Index> places = cavity_.triangles;
    while (places.size() < border.size()) {
        places.push_back(static_cast<Index>(triangles_.size()));
        triangles_.emplace_back();
        seen_.push_back(0);
    }
    for (std::size_t i = 0; i < border.size(); ++i) {
        const auto& [start, end, outside, is_fixed] = border[i];
        const Index t = places[i];
        triangles_[t] = {.vertices = {made, start, end}, .fixed = static_cast<std::uint8_t>(is_fixed ? 1 : 0)};
        link(3 * t, outside);
        corners_[start] = 3 * t + 1;
        fan_[start] = t;
    }
    for (std::size_t i = 0; i < border.size(); ++i) link(3 * places[i] + 1, 3 * fan_[border[i].end] + 2);
    corners_.push_back(3 * places[0]);
    cavity_.triangles = std::move(places);
    return made;
}

void Triangulation::set_fixed(Index corner)
{
    for (const Index each : {corner, twin(corner)})
        triangles_[each / 3].fixed = static_cast<std::uint8_t>(triangles_[each / 3].fixed | 1U << (each % 3));
}

void Triangulation::release(Index a, Index b)
{
    const Index corner = *edge_between(a, b);
    for (const Index each : {corner, twin(corner)})
        triangles_[each / 3].fixed = static_cast<std::uint8_t>(triangles_[each / 3].fixed & ~(1U << (each % 3)));
}

std::optional<Triangulation::Index> Triangulation::triangle_left_of(Index a, Index b) const
{
    if (const auto corner = edge_between(a, b)) return *corner / 3;
    return std::nullopt;
}

/// The corner opposite the edge from a to b, in the triangle to its left.
std::optional<Triangulation::Index> Triangulation::edge_between(Index a, Index b) const
{
    if (is_frame(a) && !is_frame(b)) { // around the frame's vertices is no full turn
        const auto other_way = edge_between(b, a);
        return other_way ? std::optional(twin(*other_way)) : std::nullopt;
    }
    Index corner = corners_[a];
    do {
        if (vertex(next(corner)) == b) return previous(corner);
        corner = turned(corner);
    } while (corner != none && corner != corners_[a]);
    return std::nullopt;
}

/// The edges that a line between two vertices crosses, from the first to the second; or what is in its way.
std::optional<std::array<Triangulation::Index, 2>> Triangulation::crossings(Index a, Index b,
                                                                            std::vector<CellEdge>& found) const
{
    const auto side = [&](Index v) { return orientation(points_[a], points_[b], points_[v]); };
    Index corner = corners_[a];
    while (true) { // the triangle of a that the line leaves through
        const Index u = vertex(next(corner)), v = vertex(previous(corner));
        if (side(u) == 0.0 && dot(points_[b] - points_[a], points_[u] - points_[a]) > 0.0) return std::array{u, u};
        if (side(u) < 0.0 && side(v) > 0.0) break;
        corner = turned(corner);
    }
    while (true) {
        const Index u = vertex(next(corner)), v = vertex(previous(corner));
        if (is_fixed(corner)) return std::array{u, v};
        found.push_back({u, v});
        const Index across = twin(corner), w = vertex(across);
        if (w == b) return std::nullopt;
        const double of_w = side(w);
        if (of_w == 0.0) return std::array{w, w};
        corner = of_w < 0.0 ? previous(across) : next(across); // w takes the place of the end on its own side
    }
}

std::optional<std::array<Triangulation::Index, 2>> Triangulation::fix(Index a, Index b)
{
    if (const auto corner = edge_between(a, b)) {
        set_fixed(*corner);
        return std::nullopt;
    }
    std::vector<CellEdge> crossed;
    if (const auto obstacle = crossings(a, b, crossed)) return obstacle;
    std::vector<CellEdge> made;
    for (std::size_t i = 0; i < crossed.size(); ++i) {
        const CellEdge edge = crossed[i];
        const Index corner = *edge_between(edge[0], edge[1]);
        if (!is_convex(corner)) {
            crossed.push_back(edge);
            continue;
        }
        const CellEdge diagonal{vertex(corner), vertex(twin(corner))};
        flip(corner);
        const auto is_end = [&](CellNode v) { return v == a || v == b; };
        const bool still_crosses = !is_end(diagonal[0]) && !is_end(diagonal[1]) &&
                                   is_left(points_[a], points_[b], points_[diagonal[0]]) !=
                                       is_left(points_[a], points_[b], points_[diagonal[1]]);
        (still_crosses ? crossed : made).push_back(diagonal);
    }
    set_fixed(*edge_between(a, b));
    std::vector<Index> corners;
    for (const auto& [u, v] : made) corners.push_back(*edge_between(u, v));
    legalize(std::move(corners));
    return std::nullopt;
}

/// Whether the two triangles of an edge make a convex quadrilateral, without three corners in line.
bool Triangulation::is_convex(Index corner) const
{
    const FlatPoint &p = points_[vertex(corner)], &q = points_[vertex(next(corner))],
                    &r = points_[vertex(previous(corner))], &s = points_[vertex(twin(corner))];
    return is_left(p, q, s) && is_left(p, s, r);
}

bool Triangulation::is_illegal(Index corner) const
{
    const Index other = twin(corner);
    if (other == none || is_fixed(corner)) return false;
    const auto& [a, b, c] = triangles_[corner / 3].vertices;
    return in_circle(points_[a], points_[b], points_[c], points_[vertex(other)]) > 0.0;
}

/// Turns the edge opposite the corner of p between q and r to run from p to s:
///
///      r               r
///     /|\             / \ .
///    p | s    ->     p---s
///     \|/             \ /
///      q               q
///
/// The corner of p in the triangle p q s, which lies opposite q s.
Triangulation::Index Triangulation::flip(Index corner)
{
    const Index other = twin(corner), t = corner / 3, u = other / 3;
    const Index p = vertex(corner), q = vertex(next(corner)), r = vertex(previous(corner)), s = vertex(other);
    struct Side {
        Index outside;
        bool is_fixed;
    };
    const auto side = [&](Index at) { return Side{twin(at), is_fixed(at)}; };
    const Side qs = side(next(other)), pq = side(previous(corner)), sr = side(previous(other)), rp = side(next(corner));
    const auto bits = [](const Side& first, const Side& last, int place) {
        return static_cast<std::uint8_t>((first.is_fixed ? 1 : 0) | (last.is_fixed ? 1 << place : 0));
    };
    triangles_[t] = {.vertices = {p, q, s}, .fixed = bits(qs, pq, 2)};
    triangles_[u] = {.vertices = {p, s, r}, .fixed = bits(sr, rp, 1)};
    link(3 * t, qs.outside);
    link(3 * t + 2, pq.outside);
    link(3 * u, sr.outside);
    link(3 * u + 1, rp.outside);
    link(3 * t + 1, 3 * u + 2);
    corners_[p] = 3 * t;
    corners_[q] = 3 * t + 1;
    corners_[s] = 3 * t + 2;
    corners_[r] = 3 * u + 2;
    return 3 * t;
}

void Triangulation::legalize(std::vector<Index> corners)
{
    while (!corners.empty()) {
        const Index corner = corners.back();
        corners.pop_back();
        if (!is_illegal(corner)) continue;
        const Index t = flip(corner) / 3, u = twin(3 * t + 1) / 3;
        for (const Index each : {3 * t, 3 * t + 2, 3 * u, 3 * u + 1}) corners.push_back(each);
    }
}

void Triangulation::restore()
{
    std::vector<Index> corners;
    for (Index corner = 0; corner < 3 * triangles_.size(); ++corner)
        if (twin(corner) != none && corner < twin(corner)) corners.push_back(corner);
    legalize(std::move(corners));
}

} // namespace topology
