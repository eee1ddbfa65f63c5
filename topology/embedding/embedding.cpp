#include "topology/embedding/embedding.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "topology/embedding/flat_face.h"
#include "topology/halfedge/check/shells.h"
#include "topology/modeling/mass_properties.h"

namespace topology {

std::string_view pattern(EmbeddingFault fault)
{
    switch (fault) {
    case EmbeddingFault::ZeroLengthEdge: return "edge {0} has no length; move one of its ends";
    case EmbeddingFault::NoArea: return "face {0} encloses no area";
    case EmbeddingFault::NotPlanar:
        return "face {0} is not plane: {1} is farthest from it; move the vertex or divide it";
    case EmbeddingFault::RingTurned: return "ring {0} of face {1} runs counter-clockwise; a ring runs clockwise";
    case EmbeddingFault::RingOutside: return "ring {0} is not inside face {1}; move it with RINGMV";
    case EmbeddingFault::EdgesMeet: return "edges {0} and {1} of one face meet elsewhere than at a common end";
    case EmbeddingFault::VertexOnFace: return "vertex {0} touches the inside of face {1}";
    case EmbeddingFault::EdgeThroughFace: return "edge {0} goes through face {1}";
    case EmbeddingFault::InsideOut: return "the shell of face {0} is inside out: its faces look inward";
    }
    return "";
}

std::string sentence(const EmbeddingFinding& finding, const EntityName& name)
{
    return sentence_of(pattern(finding.fault), finding.entities, name);
}

namespace {

class Inspection {
public:
    explicit Inspection(const Solid& solid) : solid_(solid)
    {
        Box box = box_of(*solid.vertices().begin());
        for (const VertexId v : solid.vertices()) box.include(solid.point(v));
        tolerance_ = 1e-9 * length(box.most - box.least);
    }

    std::vector<EmbeddingFinding> take()
    {
        for (const EdgeId e : solid_.edges())
            if (length(at_end(e) - at_start(e)) <= tolerance_) add(EmbeddingFault::ZeroLengthEdge, e, e);
        for (const FaceId f : solid_.faces()) inspect(FlatFace(solid_, f, tolerance_));
        for (const FlatFace& face : plane_) meetings(face);
        shells_outward();
        return std::move(found_);
    }

private:
    template <class A, class B> void add(EmbeddingFault fault, A a, B b) { found_.push_back({fault, {a, b}}); }
    const Point& at_start(EdgeId e) const { return solid_.point(solid_.start(solid_.plus(e))); }
    const Point& at_end(EdgeId e) const { return solid_.point(solid_.end(solid_.plus(e))); }
    Box box_of(VertexId v) const { return {solid_.point(v), solid_.point(v)}; }
    Box box_of(EdgeId e) const
    {
        Box box{at_start(e), at_start(e)};
        box.include(at_end(e));
        return box;
    }

    void inspect(const FlatFace& face)
    {
        if (!face.has_area()) return add(EmbeddingFault::NoArea, face.id(), face.id());
        const VertexId farthest = face.farthest();
        if (std::abs(face.height(solid_.point(farthest))) > tolerance_)
            return add(EmbeddingFault::NotPlanar, face.id(), farthest);
        for (const LoopId l : solid_.loops(face.id()))
            if (!solid_.is_outer(l)) inspect_ring(face, l);
        inspect_edges(face);
        plane_.push_back(face);
    }
    void inspect_ring(const FlatFace& face, LoopId ring)
    {
        if (!face.surrounds(solid_.point(solid_.start(solid_.half_edge(ring)))))
            add(EmbeddingFault::RingOutside, ring, face.id());
        if (face.area(ring) > tolerance_ * tolerance_) add(EmbeddingFault::RingTurned, ring, face.id());
    }
    /// In the order of x, so that only those are compared whose stretches of x overlap.
    void inspect_edges(const FlatFace& face)
    {
        std::vector<std::pair<Box, EdgeId>> edges;
        for (const EdgeId e : face.edges()) edges.emplace_back(box_of(e), e);
        std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) {
            return std::pair(a.first.least.x, a.second) < std::pair(b.first.least.x, b.second);
        });
        for (std::size_t i = 0; i < edges.size(); ++i)
            for (std::size_t j = i + 1;
                 j < edges.size() && edges[j].first.least.x <= edges[i].first.most.x + tolerance_; ++j)
                if (edges[i].first.meets(edges[j].first, tolerance_) && face.do_meet(edges[i].second, edges[j].second))
                    add(EmbeddingFault::EdgesMeet, edges[i].second, edges[j].second);
    }

    void meetings(const FlatFace& face)
    {
        for (const VertexId v : solid_.vertices()) {
            const bool may_touch = face.box().meets(box_of(v), tolerance_) && !face.has(v);
            const Point& p = solid_.point(v);
            if (may_touch && std::abs(face.height(p)) <= tolerance_ && face.holds(p))
                add(EmbeddingFault::VertexOnFace, v, face.id());
        }
        for (const EdgeId e : solid_.edges())
            if (face.box().meets(box_of(e), tolerance_) && is_pierced(face, at_start(e), at_end(e)))
                add(EmbeddingFault::EdgeThroughFace, e, face.id());
    }
    bool is_pierced(const FlatFace& face, const Point& p, const Point& q) const
    {
        const double below = face.height(p), above = face.height(q);
        const bool is_crossed = std::min(below, above) < -tolerance_ && std::max(below, above) > tolerance_;
        return is_crossed && face.holds(p + (below / (below - above)) * (q - p));
    }

    void shells_outward()
    {
        const std::vector<Shell> all = shells(solid_);
        for (const Shell& shell : all) {
            const bool is_turned = mass_properties(solid_, shell.faces).volume < -tolerance_ * extent(shell);
            if (is_turned && !is_in_another(shell, all))
                add(EmbeddingFault::InsideOut, shell.faces.front(), shell.faces.front());
        }
    }
    Box box_of(const Shell& shell) const
    {
        Box box = FlatFace(solid_, shell.faces.front(), tolerance_).box();
        for (const FaceId f : shell.faces) {
            const Box next = FlatFace(solid_, f, tolerance_).box();
            box.include(next.least);
            box.include(next.most);
        }
        return box;
    }
    /// The square of its size, as volumes are compared with a thin layer of it.
    double extent(const Shell& shell) const
    {
        const Box box = box_of(shell);
        return dot(box.most - box.least, box.most - box.least);
    }
    bool is_in_another(const Shell& shell, const std::vector<Shell>& all) const
    {
        return std::any_of(all.begin(), all.end(), [&](const Shell& other) {
            return &other != &shell && mass_properties(solid_, other.faces).volume > 0.0 &&
                   box_of(other).holds(box_of(shell), tolerance_);
        });
    }

    const Solid& solid_;
    double tolerance_ = 0.0;
    std::vector<FlatFace> plane_;
    std::vector<EmbeddingFinding> found_;
};

} // namespace

std::vector<EmbeddingFinding> embedding_faults(const Solid& solid)
{
    return solid.is_empty() ? std::vector<EmbeddingFinding>() : Inspection(solid).take();
}

} // namespace topology
