#include "topology/script/inverse.h"

#include <iterator>

#include "topology/script/wording.h"

namespace topology {

namespace {

/// A strut that is held just before a corner while a line is run that could not tell the two sides of the corner's
/// vertex apart without it: where all edges are to be split off, or all of a loop by a closed edge.
class HeldStrut {
public:
    /// \param taken  a name that the line in between makes
    HeldStrut(const NamedSolid& in, HalfEdgeId corner, const std::string& taken) : corner_(corner)
    {
        const Wording before(in.named());
        const VertexId v = in.solid.start(corner);
        std::string tip = in.names.vertices.unused(in.names.vertices.of(v) + "'", in.solid);
        if (tip == taken) tip = in.names.vertices.unused(tip + "'", in.solid);
        made_ = "mev " + in.name + before.face_of(corner) + before.corner(corner) + " " + tip +
                before.point(in.solid.point(v));
        killed_ = "kev " + in.name + before.vertex(v) + " " + tip;
        runner_.add({.name = in.name, .solid = in.solid, .journal = {}, .names = in.names});
        runner_.run_line(made_);
    }

    Wording say() const { return Wording(with().named()); }
    HalfEdgeId half() const { return with().solid.mate(with().solid.prev(corner_)); } ///< that starts at the vertex
    std::vector<std::string> around(const std::string& line) const { return {made_, line, killed_}; }

private:
    const NamedSolid& with() const { return runner_.solids().front(); }

    ScriptRunner runner_;
    HalfEdgeId corner_;
    std::string made_, killed_;
};

/// Says the inverse of a journal's last step. What the step killed is still read from the rows of the dead.
class Inverse {
public:
    explicit Inverse(const NamedSolid& after)
        : in_(after), t_(after.solid.tables()), step_(after.journal[after.journal.n_done() - 1]), say_(after.named())
    {}

    std::vector<std::string> lines()
    {
        switch (step_.kind) {
        case OperatorKind::KEV: return vertex_unkilled();
        case OperatorKind::KEF: return face_unkilled();
        default: return {line()};
        }
    }

private:
    std::string line() const
    {
        const VertexId w{step_.other};
        const FaceId f{step_.other}, a{step_.a}, b{step_.b};
        const LoopId l{step_.a};
        switch (step_.kind) {
        case OperatorKind::MVFS: return "kvfs " + in_.name + say_.face_of(t_.vertices[w].half_edge);
        case OperatorKind::KVFS: return "mvfs " + in_.name + say_.face(a) + lone_vertex(t_.faces[a].outer);
        case OperatorKind::MEV: return "kev " + in_.name + say_.ends(newest().minus);
        case OperatorKind::SEMV: return "jekv " + in_.name + say_.ends(newest().minus);
        case OperatorKind::JEKV:
            return "semv " + in_.name + say_.ends(t_.next(step_.second())) + with_point(t_.start(step_.first()));
        case OperatorKind::MVR: return "kvr " + in_.name + say_.face_of(t_.vertices[w].half_edge) + say_.vertex(w);
        case OperatorKind::KVR: return "mvr " + in_.name + say_.face(t_.loops[l].face) + lone_vertex(l);
        case OperatorKind::MEF:
            return "kef " + in_.name + say_.face_of(newest().plus) + say_.ends_in_face(newest().plus);
        case OperatorKind::KEMR: return edge_unkilled();
        case OperatorKind::MEKR: return ring_unkilled();
        case OperatorKind::KFMRH:
            return "mfkrh " + in_.name + say_.face(a) + say_.corner(t_.faces[b].outer) + say_.face(b);
        case OperatorKind::MFKRH: return "kfmrh " + in_.name + say_.face(FaceId{step_.old[0]}) + say_.face(f);
        case OperatorKind::RINGMV:
            return "ringmv " + in_.name + say_.face(t_.loops[l].face) + say_.corner(l) +
                   say_.face(FaceId{step_.old[0]});
        default: break;
        }
        const VertexId moved{step_.a};
        return "move " + in_.name + say_.vertex(moved) + say_.point(in_.journal.moved_from());
    }

    Edge newest() const { return t_.edges[t_.edges.last()]; }
    std::string with_point(VertexId v) const { return say_.vertex(v) + say_.point(t_.vertices[v].point); }
    std::string lone_vertex(LoopId l) const { return with_point(t_.start(t_.loops[l].half_edge)); }
    /// A corner of the ring by its number, which means the same when lines before this one have made more corners.
    std::string numbered(LoopId ring) const { return " %" + std::to_string(in_.solid.half_edge(ring).index + 1); }

    /// The edge of `plus`, from the killed vertex w to the staying one v.
    std::vector<std::string> vertex_unkilled() const
    {
        const HalfEdgeId plus = step_.first(), minus = step_.second();
        const VertexId w = t_.start(plus);
        if (in_.solid.has(minus)) return {strut(minus, w, t_.vertices[w].point)}; // v is lone now
        const HalfEdgeId from = t_.next(minus), to = t_.next(plus);
        if (from == to) return {strut(from, w, t_.vertices[w].point)};
        if (in_.solid.has(to)) return {"split " + in_.name + say_.split(from, to) + with_point(w)};
        const HeldStrut held(in_, from, in_.names.vertices.of(w));
        return held.around("split " + in_.name + held.say().split(from, held.half()) + with_point(w));
    }
    std::string strut(HalfEdgeId corner, VertexId made, const Point& point) const
    {
        return "mev " + in_.name + say_.face_of(corner) + say_.corner(corner) + say_.vertex(made) + say_.point(point);
    }

    /// The corner where the edge's half h began, among those that live.
    HalfEdgeId corner_left(HalfEdgeId h) const { return in_.solid.has(h) ? h : t_.next(t_.prev(h)); }

    std::string edge_unkilled() const
    {
        const HalfEdgeId near = corner_left(step_.first()), far = corner_left(step_.second());
        return "mekr " + in_.name + say_.face_of(near) + say_.corner(near) + say_.corner(far);
    }
    /// The part that has the outer loop keeps it.
    std::string ring_unkilled() const
    {
        const HalfEdgeId h = step_.was_outer != 0 ? newest().minus : newest().plus;
        return "kemr " + in_.name + say_.face_of(h) + say_.ends_in_face(h);
    }

    /// The edge of h, whose mate bounded the dead face by its outer loop or by a ring.
    std::vector<std::string> face_unkilled()
    {
        const LoopId dead_loop{step_.other};
        const FaceId dead = t_.loops[dead_loop].face, f = t_.loops[t_.loop(step_.first())].face;
        const bool was_ring = t_.faces[dead].outer != dead_loop;
        const std::string made = was_ring ? " " + in_.names.faces.unused(in_.names.faces.of(dead) + "'", in_.solid)
                                          : say_.face(dead);
        std::vector<std::string> lines;
        if (was_ring)
            lines.push_back("mfkrh " + in_.name + say_.face(f) + say_.corner(t_.faces[dead].outer) + say_.face(dead));
        for (std::string& line : split_face(f, made)) lines.push_back(std::move(line));
        if (was_ring) lines.push_back("kfmrh " + in_.name + say_.face(dead) + made);
        for (LoopId l = t_.loops[dead_loop].next; l != dead_loop; l = t_.loops[l].next) {
            if (l != t_.faces[dead].outer)
                lines.push_back("ringmv " + in_.name + say_.face(f) + numbered(l) + say_.face(dead));
            if (l == t_.loops[dead_loop].prev) break;
        }
        return lines;
    }
    std::vector<std::string> split_face(FaceId f, const std::string& made) const
    {
        const HalfEdgeId h = step_.first(), mate = step_.second();
        const bool is_lone = in_.solid.has(mate);
        const HalfEdgeId to = is_lone ? mate : t_.next(h), from = is_lone ? mate : t_.next(mate);
        const bool is_closed_from = from == mate, is_closed_to = to == h; // the edge alone was one of the two loops
        if (is_closed_to && !is_closed_from) {                            // in the face that stays
            const HeldStrut held(in_, from, "");
            return held.around("mef " + in_.name + say_.face(f) + held.say().corner(from) +
                               held.say().corner(held.half()) + made);
        }
        return {"mef " + in_.name + say_.face(f) + say_.corner(is_closed_from && !is_lone ? to : from) +
                say_.corner(is_closed_to ? from : to) + made};
    }

    const NamedSolid& in_;
    const Tables& t_;
    Step step_;
    Wording say_;
};

} // namespace

std::vector<std::string> inverse_lines(const NamedSolid& after, std::size_t n_operators)
{
    if (n_operators == 1) return Inverse(after).lines();
    NamedSolid now = after;
    EulerOperator op(now.solid, now.journal);
    std::vector<std::string> lines;
    for (; n_operators != 0; --n_operators) {
        std::vector<std::string> next = Inverse(now).lines();
        std::move(next.begin(), next.end(), std::back_inserter(lines));
        op.undo();
    }
    return lines;
}

} // namespace topology
