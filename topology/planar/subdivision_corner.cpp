// Where a piece leaves a vertex: between which of the edges that are there.
#include "topology/planar/planar_subdivision.h"

namespace topology {

namespace {

constexpr double like_direction = 0.02; // of a pseudo-angle: what is so near is told apart with care

/// How far b is turned clockwise from a, growing with the angle, 0 to 4 for a whole turn.
double clockwise(const FlatVector& a, const FlatVector& b)
{
    const double along = dot(a, b), right = -cross(a, b), size = std::abs(along) + std::abs(right);
    if (size == 0.0) return 0.0;
    if (right >= 0.0) return 1.0 - along / size;
    return 3.0 + along / size;
}

} // namespace

/// How far b leaves to the left of a, where both leave one vertex: an angle, of curves that touch there one as they
/// have it farther on.
double PlanarSubdivision::angle_between(const Piece& a, const Piece& b) const
{
    const FlatVector da = direction(a), db = direction(b);
    const double sine = cross(da, db) / (length(da) * length(db));
    const double most = std::min(extent(a), extent(b));
    // bent away from each other they could come back, closer than snap, if the angle were smaller
    const bool is_clear = sine * sine * most > 16.0 * snap_;
    if (is_clear || dot(da, db) < 0.0) return std::atan2(cross(da, db), dot(da, db));
    const auto at_distance = [&](const Piece& piece, double wanted) {
        double low = 0.0, high = 1.0;
        for (int i = 0; i < 60; ++i) {
            const double share = 0.5 * (low + high);
            (distance(piece.from, place(piece, share)) < wanted ? low : high) = share;
        }
        return place(piece, low) - piece.from;
    };
    double angle = 0.0;
    for (double r = 1.0 / 64.0; r <= 1.0 && std::abs(angle) * r * most <= snap_; r *= 2.0) {
        const FlatVector pa = at_distance(a, r * most), pb = at_distance(b, r * most);
        angle = cross(pa, pb) / (length(pa) * length(pb));
    }
    return angle;
}

/// The half-edge that is met first by turning clockwise from the piece that is to leave v.
HalfEdgeId PlanarSubdivision::corner(VertexId v, const Piece& leaving) const
{
    const HalfEdgeId first = solid_.half_edge(v);
    if (solid_.next_around_vertex(first) == first) return first;
    const FlatVector d = direction(leaving);
    HalfEdgeId best = first;
    double least = 5.0;
    for (const HalfEdgeId h : solid_.fan(v)) {
        const Piece there = piece(h);
        double angle = clockwise(d, direction(there));
        if (angle < like_direction || angle > 4.0 - like_direction)
            angle = angle_between(leaving, there) > 0.0 ? 4.0 : 0.0;
        const bool is_tie = std::abs(angle - least) <= like_direction;
        if (is_tie ? angle_between(piece(best), there) > 0.0 : angle < least) {
            best = h;
            least = angle;
        }
    }
    return best;
}

} // namespace topology
