#include "topology/modeling/split.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "topology/modeling/mass_properties.h"
#include "topology/modeling/plane_sides.h"

namespace topology {

namespace {

/// Is p inside the loop, both seen along `direction`? Counts how often a ray from p meets the loop.
bool is_inside(const Solid& solid, LoopId l, const Point& p, const Vector& direction)
{
    const Vector a = std::abs(direction.x) < std::abs(direction.z) ? Vector{1, 0, 0} : Vector{0, 0, 1};
    const Vector u = cross(direction, a), v = cross(direction, u);
    bool is_in = false;
    for (const HalfEdgeId h : solid.chain(l)) {
        const Vector from = solid.point(solid.start(h)) - p, to = solid.point(solid.end(h)) - p;
        const double v0 = dot(from, v), v1 = dot(to, v);
        if ((v0 > 0.0) == (v1 > 0.0)) continue;
        const double crossing = dot(from, u) + v0 / (v0 - v1) * (dot(to, u) - dot(from, u));
        if (crossing > 0.0) is_in = !is_in;
    }
    return is_in;
}

class Cut {
public:
    Cut(EulerOperator& op, const Plane& plane, PlaneSides sides)
        : op_(op), solid_(op.solid()), plane_(plane), sides_(std::move(sides))
    {}

    Split take()
    {
        mark_crossings();
        std::vector<FaceId> faces;
        for (const FaceId f : solid_.faces()) faces.push_back(f);
        for (const FaceId f : faces) cut_face(f);
        for (const VertexId v : on_plane_)
            if (!is_done(v)) open_cycle(v);
        take_away_null_edges();
        take_away_slits();
        nest(done_.above, -1.0);
        nest(done_.below, 1.0);
        return done_;
    }

private:
    /// A vertex on each edge that crosses.
    void mark_crossings()
    {
        std::vector<EdgeId> edges;
        for (const EdgeId e : solid_.edges()) edges.push_back(e);
        first_on_ = static_cast<std::uint32_t>(solid_.vertices().n_rows());
        for (const EdgeId e : edges) {
            const HalfEdgeId h = solid_.plus(e);
            const VertexId v = solid_.start(h), w = solid_.end(h);
            if (sides_.counts_as_above(v) == sides_.counts_as_above(w)) continue;
            slope_.push_back(slope(v, w));
            on_plane_.push_back(op_.semv(h, crossing(v, w)).vertex);
        }
        is_done_.resize(on_plane_.size());
    }
    bool is_on(VertexId v) const { return v.index >= first_on_ && v.index < first_on_ + on_plane_.size(); }
    std::vector<bool>::reference done(VertexId v) { return is_done_[v.index - first_on_]; }
    bool is_done(VertexId v) const { return is_done_[v.index - first_on_]; }
    bool is_above(VertexId v) const { return !is_on(v) && sides_.counts_as_above(v); }

    /// Where the edge between two vertices crosses: exactly at the one that lies on the plane; midway if both do.
    Point crossing(VertexId v, VertexId w) const
    {
        const Point &p = solid_.point(v), &q = solid_.point(w);
        const double a = sides_.height_of(v), b = sides_.height_of(w);
        if (a == 0.0 && b == 0.0) return p + 0.5 * (q - p);
        if (a == 0.0) return p;
        if (b == 0.0) return q;
        return p + a / (a - b) * (q - p);
    }
    /// Which way the crossing goes where one of the two lies on the plane, and the plane goes off to the other's side.
    Vector slope(VertexId v, VertexId w) const
    {
        const double a = std::abs(sides_.height_of(v)), b = std::abs(sides_.height_of(w));
        if ((a == 0.0) == (b == 0.0)) return {};
        const Vector along = solid_.point(w) - solid_.point(v);
        return a == 0.0 ? 1.0 / b * along : -1.0 / a * along;
    }

    /// The corners where a face meets the plane lie on one line; between the first and second, the third and fourth ...
    /// of them the line is inside the face.
    void cut_face(FaceId f)
    {
        std::vector<HalfEdgeId> corners;
        for (const LoopId l : solid_.loops(f))
            for (const HalfEdgeId h : solid_.chain(l))
                if (is_on(solid_.start(h))) corners.push_back(h);
        if (corners.empty()) return;
        const Vector normal = area_vector(solid_, f), along = cross(normal, plane_.normal);
        const auto place = [&](HalfEdgeId h) {
            const VertexId v = solid_.start(h);
            return std::pair(dot(along, solid_.point(v) - plane_.origin), dot(along, slope_[v.index - first_on_]));
        };
        std::sort(corners.begin(), corners.end(), [&](HalfEdgeId a, HalfEdgeId b) { return place(a) < place(b); });
        std::vector<FaceId> pieces{f};
        for (std::size_t i = 0; i + 1 < corners.size(); i += 2) join(corners[i], corners[i + 1], pieces);
        for (std::size_t i = 0; i < pieces.size(); ++i) settle_rings(pieces[i], pieces, normal);
    }

    void join(HalfEdgeId a, HalfEdgeId b, std::vector<FaceId>& pieces)
    {
        const LoopId l = solid_.loop(a), m = solid_.loop(b);
        if (l == m) {
            pieces.push_back(op_.mef(a, b).face);
            return;
        }
        // A loop that another piece took along comes back before it is joined.
        if (solid_.face(l) != solid_.face(m)) {
            if (solid_.is_outer(m)) op_.ringmv(l, solid_.face(m));
            else op_.ringmv(m, solid_.face(l));
        }
        op_.mekr(a, b);
    }

    void settle_rings(FaceId f, const std::vector<FaceId>& pieces, const Vector& normal)
    {
        std::vector<LoopId> rings;
        for (const LoopId l : solid_.loops(f))
            if (!solid_.is_outer(l)) rings.push_back(l);
        for (const LoopId ring : rings) {
            const Point& p = farthest(ring);
            for (const FaceId g : pieces)
                if (g != solid_.face(ring) && is_inside(solid_, solid_.outer(g), p, normal)) op_.ringmv(ring, g);
        }
    }

    /// The corner farthest from the plane: others may lie on a cut, and so on the edge of two pieces.
    const Point& farthest(LoopId l) const
    {
        HalfEdgeId best = solid_.half_edge(l);
        const auto distance = [&](HalfEdgeId h) { return std::abs(plane_.height(solid_.point(solid_.start(h)))); };
        for (const HalfEdgeId h : solid_.chain(l))
            if (distance(h) > distance(best)) best = h;
        return solid_.point(solid_.start(best));
    }

    HalfEdgeId upward(VertexId v) const
    {
        for (const HalfEdgeId h : solid_.fan(v))
            if (is_above(solid_.end(h))) return h;
        return solid_.half_edge(v); // not reached: the edge that crosses here goes on above
    }

    /// Follows the cut from v until it closes, and opens the solid along it.
    void open_cycle(VertexId v)
    {
        std::vector<HalfEdgeId> up;
        for (VertexId w = v; !is_done(w); w = solid_.end(solid_.next_around_vertex(up.back()))) {
            done(w) = true;
            up.push_back(upward(w));
        }
        std::vector<HalfEdgeId> down; // from each vertex's copy above to itself: edges of no length
        for (const HalfEdgeId h : up) {
            const NewEdge edge = op_.mev(h, solid_.next_around_vertex(h), solid_.point(solid_.start(h)));
            down.push_back(edge.plus);
            copies_.push_back(edge.vertex);
        }
        for (std::size_t i = 0; i < up.size(); ++i) op_.mef(down[i], up[(i + 1) % up.size()]);
        for (std::size_t i = 1; i < down.size(); ++i) op_.kef(down[i]);
        done_.above.push_back(solid_.face(down.front()));
        done_.below.push_back(op_.mfkrh(op_.kemr(down.front())));
    }

    /// Edges of no length, where the cut passed a vertex: what it made there falls into that vertex.
    void take_away_null_edges()
    {
        for (const std::vector<VertexId>* made : {&on_plane_, &copies_})
            for (const VertexId v : *made)
                for (const HalfEdgeId h : solid_.fan(v))
                    if (solid_.end(h) != v && solid_.point(solid_.end(h)) == solid_.point(v)) {
                        op_.kev(h);
                        break;
                    }
    }

    /// Faces of one or two edges, and edges that nothing goes on from: they have no area.
    void take_away_slits()
    {
        std::vector<FaceId> faces;
        for (const FaceId f : solid_.faces()) faces.push_back(f);
        for (bool is_changed = true; is_changed;) {
            is_changed = false;
            for (const FaceId f : faces) is_changed |= solid_.has(f) && take_away_slit(f);
        }
    }
    bool take_away_slit(FaceId f)
    {
        const HalfEdgeId h = solid_.half_edge(solid_.outer(f)), next = solid_.next(h);
        const bool is_narrow = solid_.next(next) == h;
        if (!is_narrow || solid_.face(solid_.loop(solid_.mate(h))) == f) return false;
        op_.kef(solid_.mate(h));
        return true;
    }

    /// A cut that runs the other way about lies in another one's face, as a ring.
    void nest(std::vector<FaceId>& lids, double outward)
    {
        std::erase_if(lids, [&](FaceId f) { return !solid_.has(f); });
        std::vector<FaceId> outer, holes;
        for (const FaceId f : lids)
            (outward * dot(area_vector(solid_, f), plane_.normal) > 0.0 ? outer : holes).push_back(f);
        std::vector<FaceId> host;
        for (const FaceId f : holes) host.push_back(smallest_about(f, outer));
        for (std::size_t i = 0; i < holes.size(); ++i) op_.kfmrh(host[i], holes[i]);
        lids = outer;
    }
    FaceId smallest_about(FaceId hole, const std::vector<FaceId>& outer) const
    {
        const Point& p = solid_.point(solid_.start(solid_.half_edge(solid_.outer(hole))));
        FaceId best = outer.front();
        double least = std::numeric_limits<double>::infinity();
        for (const FaceId f : outer) {
            const double area = length(area_vector(solid_, f));
            if (area >= least || !is_inside(solid_, solid_.outer(f), p, plane_.normal)) continue;
            least = area;
            best = f;
        }
        return best;
    }

    EulerOperator& op_;
    const Solid& solid_;
    Plane plane_;
    PlaneSides sides_;
    std::uint32_t first_on_ = 0; // vertices from this index on were made on the plane
    std::vector<VertexId> on_plane_;
    std::vector<Vector> slope_;    // parallel to on_plane_
    std::vector<VertexId> copies_; // of those, in the parts above
    std::vector<bool> is_done_;
    Split done_;
};

} // namespace

std::optional<Refusal> why_not_split(const EulerOperator& op, const Plane& plane)
{
    const auto torn = sides_of(op.solid(), plane).torn;
    return torn ? std::optional(Refusal{.kind = RefusalKind::OnPlane, .entities = {*torn}}) : std::nullopt;
}

Split split(EulerOperator& op, const Plane& plane)
{
    PlaneSides sides = sides_of(op.solid(), plane);
    if (sides.torn) throw EulerError({.kind = RefusalKind::OnPlane, .entities = {*sides.torn}});
    return Cut(op, plane, std::move(sides)).take();
}

} // namespace topology
