// How a subdivision changes: by the kernel's operators, and what its edges are part of along with them.
#include <stdexcept>
#include <utility>

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

Point lifted(const FlatPoint& p) { return {p.x, p.y, 0.0}; }
CurvePart backwards(const CurvePart& part) { return {part.curve, {part.span.to, part.span.from}}; }

} // namespace

// ---------------------------------------------------------------------------------------------------- undo

void PlanarSubdivision::begin() { marks_.push_back({journal_.n_done(), curves_.size(), changes_.size()}); }

void PlanarSubdivision::undo()
{
    const Mark mark = marks_.back();
    marks_.pop_back();
    EulerOperator op(solid_, journal_);
    while (journal_.n_done() > mark.n_steps) op.undo();
    while (changes_.size() > mark.n_changes) {
        Change& last = changes_.back();
        parts_[last.edge.index] = last.part;
        if (last.others.empty()) others_.erase(last.edge);
        else others_[last.edge] = std::move(last.others);
        changes_.pop_back();
    }
    parts_.resize(solid_.edges().n_rows());
    curves_.erase(curves_.begin() + static_cast<std::ptrdiff_t>(mark.n_curves), curves_.end());
}

void PlanarSubdivision::change(EdgeId e)
{
    const auto others = others_.find(e);
    changes_.push_back({e, parts_[e.index], others == others_.end() ? std::vector<CurvePart>{} : others->second});
}

// ---------------------------------------------------------------------------------------------------- the grid

void PlanarSubdivision::reserve(const FlatBox& box, std::size_t n_edges)
{
    n_expected_ = std::max(n_edges, n_expected_);
    fit_grid(box);
}

/// Cells for all that is there, and for what comes next.
void PlanarSubdivision::fit_grid(const FlatBox& box)
{
    const bool is_crowded = solid_.edges().n_rows() > 4 * n_expected_;
    if (edges_.covers(box) && !is_crowded) return;
    if (is_crowded) n_expected_ = 2 * solid_.edges().n_rows();
    FlatBox all = box;
    if (!edges_.box().is_empty()) {
        all.add(edges_.box().low);
        all.add(edges_.box().high);
    }
    all = all.grown(std::max(0.1 * all.diagonal(), 10.0 * snap_));
    edges_ = EdgeGrid(all, n_expected_);
    points_ = EdgeGrid(all, std::max<std::size_t>(64, n_expected_ / 16));
    for (const EdgeId e : solid_.edges()) add_to_grid(e);
    for (const VertexId v : solid_.vertices())
        if (!solid_.edge(solid_.half_edge(v))) points_.at(at(v)).push_back(v.index);
}

void PlanarSubdivision::add_to_grid(EdgeId e)
{
    const CurvePart& of = parts_[e.index];
    const auto put = [&](EdgeGrid::Numbers& cell) {
        if (cell.empty() || cell.back() != e.index) cell.push_back(e.index);
    };
    edges_.along(curves_[of.curve], of.span, snap_, put);
}

// ---------------------------------------------------------------------------------------------------- directions

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

// ---------------------------------------------------------------------------------------------------- growing

/// \param from  where the part begins; the edge's plus half may run either way
void PlanarSubdivision::set(EdgeId e, VertexId from, const CurvePart& part)
{
    if (parts_.size() <= e.index) parts_.resize(e.index + 1);
    const bool is_along = solid_.start(solid_.plus(e)) == from;
    parts_[e.index] = is_along ? part : backwards(part);
    add_to_grid(e);
}

VertexId PlanarSubdivision::lone_vertex(const FlatPoint& at)
{
    EulerOperator op(solid_, journal_);
    const bool is_first = solid_.is_empty();
    const LoneVertex made = is_first ? op.mvfs(lifted(at)) : op.mvr(face_at(at), lifted(at));
    if (is_first) unbounded_ = made.face;
    points_.at(at).push_back(made.vertex.index);
    return made.vertex;
}

VertexId PlanarSubdivision::split(EdgeId e, double t, const FlatPoint& at)
{
    change(e);
    const HalfEdgeId plus = solid_.plus(e);
    const NewEdge made = EulerOperator(solid_, journal_).semv(plus, lifted(at));
    const CurvePart whole = parts_[e.index];
    parts_.resize(solid_.edges().n_rows());
    parts_[made.edge.index] = {whole.curve, {t, whole.span.from}}; // its plus half runs from the new vertex back
    parts_[e.index].span.from = t;
    add_to_grid(made.edge);
    const auto found = others_.find(e);
    if (found == others_.end()) return made.vertex;
    std::vector<CurvePart> firsts, lasts;
    for (const CurvePart& other : found->second) {
        const double u = curves_[other.curve].nearest(at, other.span);
        firsts.push_back({other.curve, {u, other.span.from}});
        lasts.push_back({other.curve, {u, other.span.to}});
    }
    found->second = std::move(lasts);
    changes_.push_back({made.edge, parts_[made.edge.index], {}});
    others_[made.edge] = std::move(firsts);
    return made.vertex;
}

/// An edge to a vertex that is not there yet.
VertexId PlanarSubdivision::grow(VertexId from, const FlatPoint& to, const CurvePart& along)
{
    const HalfEdgeId where = corner(from, {along, at(from), to});
    const NewEdge made = EulerOperator(solid_, journal_).mev(where, lifted(to));
    set(made.edge, from, along);
    return made.vertex;
}

/// The half-edge between the vertices that lies along the piece as well, and runs as it does.
std::optional<HalfEdgeId> PlanarSubdivision::same_edge(const Piece& piece, VertexId from, VertexId to) const
{
    if (!solid_.edge(solid_.half_edge(from))) return std::nullopt;
    for (const HalfEdgeId h : solid_.fan(from)) {
        if (solid_.end(h) != to) continue;
        const Piece there = this->piece(h);
        const bool are_straight = is_straight(piece.part) && is_straight(there.part);
        if (are_straight) return h;
        if (from == to && dot(direction(piece), direction(there)) < 0.0) continue; // its other half runs that way
        const auto is_near = [&](double share) {
            const Curve& curve = curves_[there.part.curve];
            const FlatPoint p = place(piece, share);
            return distance(curve.at(curve.nearest(p, there.part.span)), p) <= 2.0 * snap_;
        };
        if (is_near(0.25) && is_near(0.5) && is_near(0.75)) return h;
    }
    return std::nullopt;
}

/// \param along  the half-edge that runs as the part does
void PlanarSubdivision::carry(HalfEdgeId along, const CurvePart& part)
{
    const EdgeId e = *solid_.edge(along);
    change(e);
    others_[e].push_back(solid_.plus(e) == along ? part : backwards(part));
}

/// An edge between two vertices, or one more curve along the edge that is there.
EdgeId PlanarSubdivision::connect(VertexId from, VertexId to, const CurvePart& along)
{
    const Piece there{along, at(from), at(to)}, back{backwards(along), at(to), at(from)};
    if (const auto same = same_edge(there, from, to)) {
        carry(*same, along);
        return *solid_.edge(*same);
    }
    if (from == to) return close(from, along);
    const HalfEdgeId a = corner(from, there), b = corner(to, back);
    if (solid_.loop(a) == solid_.loop(b)) return split_face(a, b, there);
    const Bridge made = EulerOperator(solid_, journal_).mekr(a, b);
    set(made.edge, from, along);
    return made.edge;
}

/// An edge from a vertex to itself: by way of a vertex on it, which goes again.
EdgeId PlanarSubdivision::close(VertexId v, const CurvePart& along)
{
    const double half = along.span.middle();
    const VertexId far = grow(v, curves_[along.curve].at(half), {along.curve, {along.span.from, half}});
    const EdgeId second = connect(far, v, {along.curve, {half, along.span.to}});
    const HalfEdgeId plus = solid_.plus(second), out = solid_.start(plus) == far ? plus : solid_.minus(second);
    const HalfEdgeId before = solid_.prev(out); // the first half, which stays
    const EdgeId stays = *solid_.edge(before);
    const bool is_along = solid_.plus(stays) == before;
    change(stays);
    EulerOperator(solid_, journal_).jekv(out);
    parts_[stays.index] = is_along ? along : backwards(along);
    add_to_grid(stays);
    return stays;
}

// ---------------------------------------------------------------------------------------------------- faces

/// The two loops that a new piece makes of one: to its left the piece and then `to` ... `from`, to its right the way back
/// and then `from` ... `to`. The shorter one is walked along, the other as well where that is a sliver.
PlanarSubdivision::Sides PlanarSubdivision::sides(HalfEdgeId from, HalfEdgeId to, const Piece& piece) const
{
    const FlatPoint origin = piece.from;
    const double own = area(piece, origin);
    Sides sides{.left = own, .right = -own, .sliver = extent(piece), .is_left_shorter = false};
    HalfEdgeId i = to, j = from;
    const auto go_on = [&](HalfEdgeId& h, double& side) {
        const Piece next = this->piece(h);
        side += area(next, origin);
        sides.sliver += extent(next);
        h = solid_.next(h);
    };
    while (i != from && j != to) {
        go_on(i, sides.left);
        go_on(j, sides.right);
    }
    sides.sliver *= 4.0 * snap_;
    sides.is_left_shorter = i == from;
    if (std::abs(sides.is_left_shorter ? sides.left : sides.right) > sides.sliver) return sides;
    sides.is_other_known = true;
    while (i != from) go_on(i, sides.left);
    while (j != to) go_on(j, sides.right);
    return sides;
}

/// Whether the new face, which is always a bounded one, is that to the left of the piece.
/// \throws Tangled  neither side runs around anything
bool PlanarSubdivision::is_new_face_left(HalfEdgeId from, HalfEdgeId to, const Piece& piece) const
{
    const Sides found = sides(from, to, piece);
    const LoopId l = solid_.loop(from);
    const bool are_both_bounded = solid_.is_outer(l) && solid_.face(l) != unbounded_;
    const double shorter = found.is_left_shorter ? found.left : found.right;
    bool takes_left = found.is_left_shorter == (shorter > 0.0);
    if (found.is_other_known) takes_left = found.left > found.right;
    if (are_both_bounded) takes_left = found.is_left_shorter;
    const bool is_known = found.is_other_known || takes_left == found.is_left_shorter;
    if (is_known && (takes_left ? found.left : found.right) < -found.sliver) throw Tangled();
    return takes_left;
}

EdgeId PlanarSubdivision::split_face(HalfEdgeId from, HalfEdgeId to, const Piece& piece)
{
    EulerOperator op(solid_, journal_);
    const VertexId start = solid_.start(from);
    const NewFace made = is_new_face_left(from, to, piece) ? op.mef(to, from) : op.mef(from, to);
    set(made.edge, start, piece.part);
    move_rings(made);
    return made.edge;
}

/// Of the face that was split, those that lie in the new one.
void PlanarSubdivision::move_rings(const NewFace& made)
{
    const LoopId stays = solid_.loop(made.plus);
    const FaceId f = solid_.face(stays);
    FlatBox box;
    std::vector<HalfEdgeId> inside; // one of each: loops are named anew
    for (const LoopId l : solid_.loops(f)) {
        if (l == stays || (l == solid_.outer(f) && f != unbounded_)) continue;
        if (box.is_empty())
            for (const HalfEdgeId h : solid_.chain(made.loop)) {
                const FlatBox of_edge = curves_[part_of(h).curve].box(span(h));
                box.add(of_edge.low);
                box.add(of_edge.high);
            }
        const FlatPoint p = at(solid_.start(solid_.half_edge(l)));
        if (box.has(p) && encloses(made.loop, p)) inside.push_back(solid_.half_edge(l));
    }
    for (const HalfEdgeId h : inside) {
        if (solid_.is_outer(solid_.loop(h))) make_outer(stays);
        EulerOperator(solid_, journal_).ringmv(solid_.loop(h), made.face);
    }
}

/// Of the unbounded face: a bridge between the two loops, which leaves the ring the outer one when it is taken away.
void PlanarSubdivision::make_outer(LoopId ring)
{
    EulerOperator op(solid_, journal_);
    const HalfEdgeId from = solid_.half_edge(ring), to = solid_.half_edge(solid_.outer(solid_.face(ring)));
    const VertexId start = solid_.start(from);
    const Bridge bridge = op.mekr(from, to);
    parts_.resize(solid_.edges().n_rows());
    op.kemr(solid_.start(bridge.plus) == start ? bridge.plus : bridge.minus);
}

// ---------------------------------------------------------------------------------------------------- mending

/// Takes an edge away and leaves its vertices.
void PlanarSubdivision::remove(EdgeId e)
{
    change(e);
    others_.erase(e);
    EulerOperator op(solid_, journal_);
    HalfEdgeId h = solid_.plus(e), mate = solid_.minus(e);
    if (solid_.face(h) != solid_.face(mate)) {
        const auto goes_around = [&](HalfEdgeId half) {
            return !solid_.is_outer(solid_.loop(half)) || solid_.face(half) == unbounded_;
        };
        if (goes_around(mate)) std::swap(h, mate); // the face that is around stays
        op.kef(h);
        return;
    }
    const LoopId l = solid_.loop(h);
    if (solid_.is_outer(l) && solid_.face(l) != unbounded_) { // the part that goes around the other stays outer
        const FlatPoint origin = at(solid_.start(h));
        double at_start = 0.0; // of the part at the start of h
        for (HalfEdgeId i = solid_.next(mate); i != h; i = solid_.next(i)) at_start += area(piece(i), origin);
        if (!(at_start > 0.0)) std::swap(h, mate);
    }
    op.kemr(h);
}

/// Leads an edge by way of a vertex that is as good as on it.
void PlanarSubdivision::reroute(EdgeId e, double t, VertexId through)
{
    const HalfEdgeId plus = solid_.plus(e);
    const VertexId from = solid_.start(plus), to = solid_.end(plus);
    std::vector<CurvePart> parts = carriers(e);
    remove(e);
    for (const CurvePart& part : parts) {
        const double middle = part == parts.front() ? t : curves_[part.curve].nearest(at(through), part.span);
        connect(from, through, {part.curve, {part.span.from, middle}});
        connect(through, to, {part.curve, {middle, part.span.to}});
    }
}

} // namespace topology
