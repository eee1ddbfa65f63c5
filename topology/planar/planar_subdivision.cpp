#include "topology/planar/planar_subdivision.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace topology {

namespace {

Span reversed(Span span) { return {span.to, span.from}; }

} // namespace

std::vector<CurvePart> PlanarSubdivision::carriers(EdgeId e) const
{
    std::vector<CurvePart> all{part(e)};
    if (const auto found = others_.find(e); found != others_.end())
        all.insert(all.end(), found->second.begin(), found->second.end());
    return all;
}

Span PlanarSubdivision::span(HalfEdgeId h) const
{
    const EdgeId e = *solid_.edge(h);
    return solid_.plus(e) == h ? part(e).span : reversed(part(e).span);
}

PlanarCounts PlanarSubdivision::counts() const
{
    if (solid_.is_empty()) return {};
    const Counts all = solid_.counts();
    PlanarCounts counts{.vertices = all.vertices, .edges = all.edges, .regions = all.faces - 1};
    counts.components = all.loops - (all.faces - 1); // each is a ring of the face around it, the bounded ones have one
    for (const EdgeId e : solid_.edges())
        if (solid_.face(solid_.plus(e)) == solid_.face(solid_.minus(e))) ++counts.dangling;
    return counts;
}

bool PlanarSubdivision::has_area(LoopId l) const
{
    for (const HalfEdgeId h : solid_.chain(l))
        if (solid_.edge(h) && solid_.face(solid_.mate(h)) != solid_.face(l)) return true;
    return false;
}

std::size_t PlanarSubdivision::n_holes(FaceId f) const
{
    std::size_t n = 0;
    for (const LoopId l : solid_.loops(f))
        if ((f == unbounded_ || l != solid_.outer(f)) && has_area(l)) ++n;
    return n;
}

bool PlanarSubdivision::is_straight(const Piece& piece) const
{
    if (is_straight(piece.part)) return true;
    constexpr double short_length =
        32.0; // times snap: where vertices are beside the curve, they tell more than it does
    const Span span = piece.part.span;
    const double reach = short_length * snap_;
    if (distance(piece.from, piece.to) > reach) return false;
    const Curve& curve = curves_[piece.part.curve];
    return distance(curve.at(span.middle()), piece.from) <= reach &&
           distance(curve.at(span.at(0.25)), piece.from) <= reach;
}

FlatPoint PlanarSubdivision::place(const Piece& piece, double share) const
{
    if (is_straight(piece)) return piece.from + share * (piece.to - piece.from);
    return curves_[piece.part.curve].at(piece.part.span.at(share));
}

FlatVector PlanarSubdivision::direction(const Piece& piece) const
{
    return is_straight(piece) ? piece.to - piece.from : curves_[piece.part.curve].direction(piece.part.span);
}

double PlanarSubdivision::extent(const Piece& piece) const
{
    return std::max(distance(piece.from, piece.to), distance(piece.from, place(piece, 0.5)));
}

/// Closed by short lines where the curve's ends are not quite the vertices.
double PlanarSubdivision::area(const Piece& piece, const FlatPoint& origin) const
{
    if (is_straight(piece)) return 0.5 * cross(piece.from - origin, piece.to - origin);
    const Curve& curve = curves_[piece.part.curve];
    const Span span = piece.part.span;
    const FlatPoint first = curve.at(span.from), last = curve.at(span.to);
    return curve.area(span, origin) + 0.5 * cross(piece.from - origin, first - origin) +
           0.5 * cross(last - origin, piece.to - origin);
}

double PlanarSubdivision::area(LoopId l) const
{
    if (solid_.is_lone(l)) return 0.0;
    const FlatPoint origin = at(solid_.start(solid_.half_edge(l)));
    double sum = 0.0;
    for (const HalfEdgeId h : solid_.chain(l)) sum += area(piece(h), origin);
    return sum;
}

double PlanarSubdivision::area(FaceId f) const
{
    double sum = 0.0;
    for (const LoopId l : solid_.loops(f)) sum += area(l);
    return sum;
}

double PlanarSubdivision::perimeter(FaceId f) const
{
    double sum = 0.0;
    for (const LoopId l : solid_.loops(f))
        for (const HalfEdgeId h : solid_.chain(l)) {
            if (!solid_.edge(h) || solid_.face(solid_.mate(h)) == f) continue;
            const Curve& curve = curves_[part_of(h).curve];
            sum += curve.is_straight() ? distance(at(solid_.start(h)), at(solid_.end(h))) : curve.length(span(h));
        }
    return sum;
}

template <class Cross> void PlanarSubdivision::at_height(HalfEdgeId h, double y, const Cross& cross) const
{
    const FlatPoint a = at(solid_.start(h)), b = at(solid_.end(h));
    const Curve& curve = curves_[part_of(h).curve];
    const auto crosses = [&](double from, double to) { return (from <= y) != (to <= y); };
    if (curve.is_straight()) {
        if (crosses(a.y, b.y)) cross(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), b.y > a.y);
        return;
    }
    const Span whole = span(h);
    double from = whole.from, from_y = a.y;
    const auto see = [&](double to, double to_y) {
        if (crosses(from_y, to_y)) cross(curve.at(curve.at_height(y, {from, to})).x, to_y > from_y);
        from = to;
        from_y = to_y;
    };
    for (const double t : curve.turns_of_y(whole)) see(t, curve.at(t).y);
    see(whole.to, b.y);
}

bool PlanarSubdivision::encloses(LoopId l, const FlatPoint& p) const
{
    int turns = 0;
    for (const HalfEdgeId h : solid_.chain(l))
        at_height(h, p.y, [&](double x, bool is_upward) {
            if (x > p.x) turns += is_upward ? 1 : -1;
        });
    return turns > 0;
}

/// That on this side of what a level line to the right meets first.
FaceId PlanarSubdivision::face_at(const FlatPoint& p) const
{
    std::vector<Crossing> met; // no further than snap behind the first
    double nearest = std::numeric_limits<double>::infinity();
    const auto see = [&](EdgeId e) {
        if (!solid_.has(e)) return;
        at_height(solid_.plus(e), p.y, [&](double x, bool is_upward) {
            if (x <= p.x || x > nearest + snap_) return;
            nearest = std::min(nearest, x);
            met.push_back({x, is_upward ? solid_.plus(e) : solid_.minus(e)});
        });
    };
    if (edges_.box().has(p))
        edges_.to_the_right(
            p, [&](std::uint32_t number) { see(EdgeId{number}); }, [&](double end) { return nearest + snap_ <= end; });
    if (met.empty()) return unbounded_;
    std::erase_if(met, [&](const Crossing& crossing) { return crossing.x > nearest + snap_; });
    const HalfEdgeId first = first_of(met);
    for (const VertexId v : {solid_.start(first), solid_.end(first)}) // several edges are met at once
        if (distance(at(v), {nearest, p.y}) <= snap_) {
            const VertexId seen = seen_from(p, v);
            return solid_.face(corner(seen, {{no_curve, {}}, at(seen), p}));
        }
    return solid_.face(first);
}

/// Which of the edges that are met within snap of each other comes first, rounding does not tell: it is the one whose face
/// on this side lies behind none of the others.
HalfEdgeId PlanarSubdivision::first_of(const std::vector<Crossing>& met) const
{
    const auto is_behind_none = [&](const Crossing& crossing) {
        return std::ranges::none_of(met, [&](const Crossing& other) {
            return solid_.face(solid_.mate(other.before)) == solid_.face(crossing.before);
        });
    };
    const auto nearer = [](const Crossing& a, const Crossing& b) { return a.x < b.x; };
    const auto first = std::ranges::find_if(met, is_behind_none);
    return (first != met.end() ? first : std::ranges::min_element(met, nearer))->before;
}

/// The vertex that p sees where it looks at v along level edges, which the line to the right does not cross.
VertexId PlanarSubdivision::seen_from(const FlatPoint& p, VertexId v) const
{
    const auto is_level = [&](HalfEdgeId h) {
        const Piece along = piece(h);
        const auto is_between = [&](double share) {
            const FlatPoint there = place(along, share);
            return std::abs(there.y - p.y) <= snap_ && there.x > p.x;
        };
        return along.to.x < along.from.x && is_between(0.25) && is_between(0.5) && is_between(0.75) && is_between(1.0);
    };
    for (bool is_seen = false; !is_seen;) {
        is_seen = true;
        for (const HalfEdgeId h : solid_.fan(v)) {
            if (!is_level(h)) continue;
            v = solid_.end(h);
            is_seen = false;
            break;
        }
    }
    return v;
}

std::optional<EdgeId> PlanarSubdivision::edge_at(const FlatPoint& p) const
{
    std::optional<EdgeId> found;
    if (!edges_.covers({p, p})) return found;
    edges_.along(Curve(Segment{p, p}), {}, snap_, [&](std::uint32_t number) {
        const EdgeId e{number};
        if (!solid_.has(e) || (found && !(e < *found))) return;
        const Curve& curve = curves_[part(e).curve];
        if (distance(curve.at(curve.nearest(p, part(e).span)), p) <= snap_) found = e;
    });
    return found;
}

double PlanarSubdivision::corner_angle(HalfEdgeId h) const
{
    const HalfEdgeId back = solid_.mate(solid_.prev(h)); // the other side of the corner, leaving it
    if (back == h) return 2.0 * std::numbers::pi;
    const double angle = angle_between(piece(h), piece(back));
    const bool are_one = std::abs(angle) < 1e-12;
    if (are_one) return 0.0;
    return angle > 0.0 ? angle : angle + 2.0 * std::numbers::pi;
}

/// On a level line half way between two of its corners' heights, the middle of the widest stretch inside; the best of
/// some such lines.
FlatPoint PlanarSubdivision::place_inside(FaceId f) const
{
    std::vector<double> heights;
    for (const LoopId l : solid_.loops(f))
        for (const HalfEdgeId h : solid_.chain(l)) {
            heights.push_back(at(solid_.start(h)).y);
            if (!solid_.edge(h)) continue;
            const Curve& curve = curves_[part_of(h).curve];
            for (const double t : curve.turns_of_y(span(h))) heights.push_back(curve.at(t).y);
        }
    std::ranges::sort(heights);
    constexpr std::size_t most_lines = 64;
    const std::size_t step = std::max<std::size_t>(1, heights.size() / most_lines);
    FlatPoint best{};
    double best_room = -1.0;
    for (std::size_t i = 0; i + 1 < heights.size(); i += step) {
        const double y = 0.5 * (heights[i] + heights[i + 1]), rise = heights[i + 1] - heights[i];
        std::vector<double> crossings;
        for (const LoopId l : solid_.loops(f))
            for (const HalfEdgeId h : solid_.chain(l))
                if (solid_.edge(h)) at_height(h, y, [&](double x, bool) { crossings.push_back(x); });
        std::ranges::sort(crossings);
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
            if (const double room = std::min(crossings[k + 1] - crossings[k], rise); room > best_room) {
                best_room = room;
                best = {0.5 * (crossings[k] + crossings[k + 1]), y};
            }
    }
    return best;
}

} // namespace topology
