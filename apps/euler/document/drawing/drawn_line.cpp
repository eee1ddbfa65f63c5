#include "apps/euler/document/drawing/drawn_line.h"

#include <cmath>

#include "apps/euler/document/drawing/line_on_figure.h"
#include "apps/euler/document/palette/free_name.h"
#include "topology/planar/planar_figure.h"
#include "topology/script/wording.h"
#include "ui/text/catalogue.h"

namespace euler {

namespace {

using topology::FaceId;
using topology::FlatPoint;
using topology::HalfEdgeId;
using topology::LoopId;
using topology::NamedSolid;
using topology::PlanarFigure;
using topology::Point;
using topology::Solid;
using topology::VertexId;
using ui::Message;
using ui::translatable;

/// Draws on a copy of the lesson, since each operator finds what the one before left.
class Drawing {
public:
    Drawing(const Stepper& lesson, std::size_t solid, const topology::Frame& frame, const Point& from, const Point& to)
        : trial_(lesson), place_(solid), frame_(frame), from_(from), to_(to)
    {}

    std::variant<std::vector<DrawnStep>, Message> take()
    {
        for (auto met = line().crossing(); met && !refused_; met = line().crossing())
            split(in().minus(met->edge), met->point);
        const std::vector<Stop> all = line().stops();
        const bool is_apart = all.size() == 2 && !all[0].vertex && !all[1].vertex;
        if (is_apart) lone_line();
        else
            for (std::size_t i = 0; i + 1 < all.size(); ++i) piece(all[i], all[i + 1]);
        if (refused_) return *refused_;
        if (steps_.empty()) return Message(translatable("an edge is there already"));
        return std::move(steps_);
    }

private:
    const NamedSolid& named() const { return trial_.runner().solids()[place_]; }
    const Solid& in() const { return named().solid; }
    const topology::Names& names() const { return named().names; }
    PlanarFigure figure() const { return {in(), frame_}; }
    topology::Wording say() const { return topology::Wording(named().named()); }
    LineOnFigure line() const { return {in(), frame_, from_, to_}; }
    FlatPoint flat(const Point& p) const { return frame_.flat(p); }

    void draw(std::string_view word, const std::string& words, Message why)
    {
        if (refused_) return;
        const std::string line = std::string(word) + " " + named().name + words;
        refused_ = trial_.apply(line);
        if (!refused_) steps_.push_back({line, std::move(why)});
    }

    void split(HalfEdgeId h, const Point& p)
    {
        const std::string made = free_vertex_name(names(), in());
        draw("semv", say().ends(h) + " " + made + say().point(p),
             {translatable("The line meets the edge from {a} to {b}: SEMV splits it and makes {v}."),
              {{"a", name(in().start(h))}, {"b", name(in().end(h))}, {"v", made}}});
    }

    std::string name(VertexId v) const { return names().vertices.of(v); }
    std::string name(FaceId f) const { return names().faces.of(f); }

    void lone_line()
    {
        const FaceId f = figure().face_at(flat(from_));
        const std::string made = free_vertex_name(names(), in());
        draw("mvr", say().face(f) + " " + made + say().point(from_),
             {translatable("The line begins free in face {f}: MVR puts the lone vertex {v} there, a ring of the face."),
              {{"f", name(f)}, {"v", made}}});
        if (!refused_) strut(*names().vertices.find(made, in()), to_);
    }
    void piece(const Stop& a, const Stop& b)
    {
        if (refused_) return;
        if (!b.vertex) strut(*a.vertex, to_);
        else if (!a.vertex) strut(*b.vertex, from_);
        else if (!are_neighbours(*a.vertex, *b.vertex)) edge(*a.vertex, *b.vertex);
    }
    bool are_neighbours(VertexId a, VertexId b) const
    {
        for (const HalfEdgeId h : in().fan(a))
            if (in().end(h) == b) return true;
        return false;
    }
    void strut(VertexId v, const Point& end)
    {
        const HalfEdgeId corner = figure().corner(v, flat(end));
        const std::string made = free_vertex_name(names(), in());
        draw("mev", say().face_of(corner) + say().corner(corner) + " " + made + say().point(end),
             {translatable("One end of the line is new: MEV grows an edge from {a} into face {f} and makes {v}."),
              {{"a", name(v)}, {"f", name(in().face(corner))}, {"v", made}}});
    }
    void edge(VertexId a, VertexId b)
    {
        const HalfEdgeId at_a = figure().corner(a, flat(in().point(b))), at_b = figure().corner(b, flat(in().point(a)));
        if (in().loop(at_a) != in().loop(at_b)) return join(at_a, at_b);
        // The new face is the one that the edge closes counter-clockwise.
        if (figure().area(at_a, at_b) > 0.0) close(at_a, at_b);
        else close(at_b, at_a);
    }
    void join(HalfEdgeId a, HalfEdgeId b)
    {
        draw("mekr", say().face_of(a) + say().corner(a) + say().corner(b),
             {translatable(
                  "The line joins two loops of face {f}, at {a} and {b}: MEKR makes one of them. No face is divided."),
              {{"f", name(in().face(a))}, {"a", name(in().start(a))}, {"b", name(in().start(b))}}});
    }
    void close(HalfEdgeId from, HalfEdgeId to)
    {
        const FaceId f = in().face(from);
        const std::string made = free_face_name(names(), in());
        if (figure().unbounded() == f) pass_rank(f, from, to);
        draw("mef", say().face(f) + say().corner(from) + say().corner(to) + " " + made,
             {translatable("Both ends lie on one loop of face {f}: the edge divides it, and MEF makes face {g}."),
              {{"f", name(f)}, {"g", made}}});
        if (!refused_) move_rings(f, *names().faces.find(made, in()));
    }

    /// Is the loop inside the polygon that an edge from `to` back to `from` would close?
    bool is_enclosed(LoopId l, HalfEdgeId from, HalfEdgeId to) const
    {
        Solid closed = in();
        const LoopId made = topology::EulerOperator(closed).mef(from, to).loop;
        return PlanarFigure(closed, frame_).winding(made, flat(in().point(in().start(in().half_edge(l))))) != 0;
    }
    /// The face around has an outer loop by rank alone. A ring moves to another face, an outer loop does not.
    void pass_rank(FaceId f, HalfEdgeId from, HalfEdgeId to)
    {
        const LoopId first = in().outer(f);
        if (in().loop(from) == first || !is_enclosed(first, from, to)) return;
        const HalfEdgeId leading = in().half_edge(first);
        const Message why(
            translatable("The loop at {a}, which leads those of the outside face {f}, will lie inside the new face: "
                         "joined to the loop at {b} by MEKR and parted again by KEMR, it follows as a ring."),
            {{"a", name(in().start(leading))}, {"f", name(f)}, {"b", name(in().start(from))}});
        const VertexId near = in().start(from), far = in().start(leading);
        draw("mekr", say().face(f) + say().corner(from) + say().corner(leading), why);
        if (refused_) return;
        for (const HalfEdgeId h : in().fan(near))
            if (in().end(h) == far && in().loop(h) == in().loop(in().mate(h)))
                return draw("kemr", say().face(f) + say().ends_in_face(h), why);
    }
    void move_rings(FaceId from, FaceId to)
    {
        std::vector<LoopId> inside;
        for (const LoopId l : in().loops(from))
            if (!in().is_outer(l) &&
                figure().winding(in().outer(to), flat(in().point(in().start(in().half_edge(l))))) != 0)
                inside.push_back(l);
        for (const LoopId l : inside)
            draw("ringmv", say().face(from) + say().corner(l) + say().face(to),
                 {translatable("The ring at {a} lies inside the new face {g}: RINGMV takes it there."),
                  {{"a", name(in().start(in().half_edge(l)))}, {"g", name(to)}}});
    }

    Stepper trial_;
    std::size_t place_;
    topology::Frame frame_;
    Point from_, to_;
    std::vector<DrawnStep> steps_;
    std::optional<Message> refused_;
};

std::vector<DrawnStep> first_line(const Stepper& lesson, const Point& from, const Point& to)
{
    const std::string s = free_solid_name(lesson.runner());
    const auto spaced = [](const Point& p) {
        const Solid none;
        const topology::Names no_names;
        return topology::Wording({none, no_names, ""}).point(p);
    };
    return {
        {"mvfs " + s + " f1 v1" + spaced(from),
         Message(translatable("Nothing is there yet: MVFS makes the vertex {v} and the face {f} around it."),
                 {{"v", "v1"}, {"f", "f1"}})},
        {"mev " + s + " f1 v1 v2" + spaced(to),
         Message(translatable("One end of the line is new: MEV grows an edge from {a} into face {f} and makes {v}."),
                 {{"a", "v1"}, {"f", "f1"}, {"v", "v2"}})}};
}

bool is_in_plane(const topology::Frame& frame, const Point& p, double extent)
{
    return std::abs(dot(frame.normal(), p - frame.origin)) <= 1e-9 * extent;
}

} // namespace

std::variant<std::vector<DrawnStep>, Message> drawn_line(const Stepper& lesson, std::optional<std::size_t> solid,
                                                         const Point& from, const Point& to)
{
    if (from == to) return Message(translatable("the line has no length"));
    if (!solid) return first_line(lesson, from, to);
    const auto frame = plane_of(lesson.runner().solids()[*solid].solid);
    if (!frame) return Message(translatable("the solid does not lie in a plane"));
    const double extent = length(from - frame->origin) + length(to - frame->origin);
    if (!is_in_plane(*frame, from, extent) || !is_in_plane(*frame, to, extent))
        return Message(translatable("the line leaves the plane of the figure"));
    return Drawing(lesson, *solid, *frame, from, to).take();
}

} // namespace euler
