// How a subdivision grows, mends itself and takes back: by the kernel's operators, and what its edges are part of with them.
#include <algorithm>
#include <utility>

#include "topology/planar/planar_subdivision.h"

namespace topology {

namespace {

Point lifted(const FlatPoint& p) { return {p.x, p.y, 0.0}; }
CurvePart backwards(const CurvePart& part) { return {part.curve, {part.span.to, part.span.from}}; }

} // namespace

void PlanarSubdivision::begin() { marks_.push_back({journal_.n_done(), curves_.size(), changes_.size()}); }

void PlanarSubdivision::undo()
{
    const Mark mark = marks_.back();
    marks_.pop_back();
    EulerOperator op(solid_, journal_);
    while (journal_.n_done() > mark.n_steps) op.undo();
    std::vector<EdgeId> missed; // by cells that were made since
    while (changes_.size() > mark.n_changes) {
        Change& last = changes_.back();
        parts_[last.edge.index] = last.part;
        if (last.others.empty()) others_.erase(last.edge);
        else others_[last.edge] = std::move(last.others);
        if (changes_.size() <= n_changes_in_grid_) missed.push_back(last.edge);
        changes_.pop_back();
    }
    parts_.resize(solid_.edges().n_rows());
    n_changes_in_grid_ = std::min(n_changes_in_grid_, changes_.size());
    for (const EdgeId e : missed)
        if (solid_.has(e)) add_to_grid(e);
    curves_.erase(curves_.begin() + static_cast<std::ptrdiff_t>(mark.n_curves), curves_.end());
}

void PlanarSubdivision::change(EdgeId e)
{
    const auto others = others_.find(e);
    changes_.push_back({e, parts_[e.index], others == others_.end() ? std::vector<CurvePart>{} : others->second});
}

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
    points_.put_at(at, made.vertex.index);
    lone_vertices_.push_back(made.vertex);
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
