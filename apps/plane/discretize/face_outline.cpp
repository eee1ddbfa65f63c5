#include "apps/plane/discretize/face_outline.h"

#include <algorithm>
#include <set>

namespace discretize {

namespace {

using femoop::NodeId;
using femoop::plane::CurveId;
using femoop::plane::RegionId;
using topology::EdgeId;
using topology::HalfEdgeId;
using topology::Solid;
using topology::VertexId;

/// Curves and points of the model where a mesh must have edges and nodes.
class Stakes {
public:
    explicit Stakes(const PlaneModel& model) : curves_(model.curves.size()), points_(model.points.size())
    {
        for (std::size_t i = 0; i < model.curves.size(); ++i)
            curves_[i] = model.curves[i].support.has_value() || !model.curves[i].tie.is_empty();
        for (std::size_t i = 0; i < model.points.size(); ++i)
            points_[i] = model.points[i].support.has_value() || model.points[i].size.has_value();
        for (const auto& load_case : model.load_cases) {
            for (const auto& load : load_case.points) points_[load.node.index] = true;
            for (const auto& load : load_case.curves) add(load.curves);
            for (const auto& settlement : load_case.settlements) {
                if (settlement.point) points_[settlement.point->index] = true;
                add(settlement.curves);
            }
        }
        for (const auto& check : model.expected)
            if (check.curve) curves_[check.curve->index] = true;
    }

    bool of_curve(CurveId curve) const { return curves_[curve.index]; }
    bool of_point(NodeId point) const { return points_[point.index]; }

private:
    void add(const std::vector<CurveId>& curves)
    {
        for (const CurveId curve : curves) curves_[curve.index] = true;
    }
    std::vector<bool> curves_, points_;
};

class OutlineMaker {
public:
    explicit OutlineMaker(const Drawing& drawing)
        : drawing_(drawing), plane_(drawing.subdivision()), solid_(plane_.solid()), stakes_(drawing.model())
    {}

    FaceOutline outline(std::size_t face) const
    {
        FaceOutline outline{.face = face, .region = *drawing_.faces()[face].region, .loops = loops(face)};
        std::set<VertexId> on_it;
        for (const OutlineLoop& loop : outline.loops)
            for (const HalfEdgeId h : loop) on_it.insert(solid_.start(h));
        for (const EdgeId e : dangling(face)) {
            if (!is_at_stake(e)) continue;
            outline.inner_edges.push_back(e);
            on_it.insert(solid_.start(solid_.plus(e)));
            on_it.insert(solid_.end(solid_.plus(e)));
        }
        for (std::size_t i = 0; i < drawing_.model().points.size(); ++i) {
            const auto vertex = drawing_.vertex(NodeId(i));
            if (!vertex || !stakes_.of_point(NodeId(i)) || on_it.contains(*vertex)) continue;
            if (solid_.face(solid_.half_edge(*vertex)) != drawing_.faces()[face].id) continue;
            outline.inner_vertices.push_back(*vertex);
            on_it.insert(*vertex);
        }
        return outline;
    }

private:
    bool dangles(HalfEdgeId h) const { return solid_.face(h) == solid_.face(solid_.mate(h)); }
    bool is_at_stake(EdgeId e) const
    {
        const auto carriers = plane_.carriers(e);
        return std::any_of(carriers.begin(), carriers.end(), [&](const topology::CurvePart& part) {
            return stakes_.of_curve(drawing_.owner(part.curve));
        });
    }

    template <class Use> void for_half_edges(std::size_t face, const Use& use) const
    {
        for (const topology::LoopId loop : solid_.loops(drawing_.faces()[face].id))
            for (const HalfEdgeId h : solid_.chain(loop))
                if (solid_.edge(h)) use(h);
    }

    std::vector<EdgeId> dangling(std::size_t face) const
    {
        std::vector<EdgeId> found;
        for_half_edges(face, [&](HalfEdgeId h) {
            const EdgeId e = *solid_.edge(h);
            if (dangles(h) && solid_.plus(e) == h) found.push_back(e);
        });
        return found;
    }

    /// The next half-edge around the face that bounds it: past those that dangle at their corner.
    HalfEdgeId next_bounding(HalfEdgeId h) const
    {
        HalfEdgeId next = solid_.next(h);
        while (dangles(next)) next = solid_.next(solid_.mate(next));
        return next;
    }

    std::vector<OutlineLoop> loops(std::size_t face) const
    {
        std::vector<OutlineLoop> found;
        std::set<HalfEdgeId> seen;
        for_half_edges(face, [&](HalfEdgeId first) {
            if (dangles(first) || seen.contains(first)) return;
            OutlineLoop loop;
            for (HalfEdgeId h = first; seen.insert(h).second; h = next_bounding(h)) loop.push_back(h);
            found.push_back(std::move(loop));
        });
        std::stable_partition(found.begin(), found.end(), [&](const OutlineLoop& loop) { return area(loop) > 0.0; });
        return found;
    }

    double area(const OutlineLoop& loop) const
    {
        const topology::FlatPoint origin = plane_.at(solid_.start(loop.front()));
        double sum = 0.0;
        for (const HalfEdgeId h : loop)
            sum += plane_.curve(plane_.part(*solid_.edge(h)).curve).area(plane_.span(h), origin);
        return sum;
    }

    const Drawing& drawing_;
    const topology::PlanarSubdivision& plane_;
    const Solid& solid_;
    Stakes stakes_;
};

} // namespace

std::vector<FaceOutline> outlines_of(const Drawing& drawing)
{
    const OutlineMaker maker(drawing);
    std::vector<FaceOutline> outlines;
    for (std::size_t i = 0; i < drawing.faces().size(); ++i) {
        const auto region = drawing.faces()[i].region;
        if (region && !drawing.model()[*region].is_hole) outlines.push_back(maker.outline(i));
    }
    std::stable_sort(outlines.begin(), outlines.end(),
                     [](const FaceOutline& a, const FaceOutline& b) { return a.region.index < b.region.index; });
    return outlines;
}

std::vector<std::vector<CurvePiece>> pieces_of_curves(const Drawing& drawing)
{
    struct Found {
        topology::CurvePart part;
        EdgeId edge;
    };
    const topology::PlanarSubdivision& plane = drawing.subdivision();
    std::vector<std::vector<Found>> found(drawing.model().curves.size());
    for (const EdgeId e : plane.solid().edges())
        for (const topology::CurvePart& part : plane.carriers(e))
            found[drawing.owner(part.curve).index].push_back({part, e});
    std::vector<std::vector<CurvePiece>> pieces(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        std::sort(found[i].begin(), found[i].end(), [](const Found& a, const Found& b) {
            return std::pair(a.part.curve, std::min(a.part.span.from, a.part.span.to)) <
                   std::pair(b.part.curve, std::min(b.part.span.from, b.part.span.to));
        });
        for (const auto& [part, edge] : found[i])
            pieces[i].push_back({.edge = edge,
                                 .is_forward = part.span.from < part.span.to,
                                 .length = plane.curve(part.curve).length(part.span)});
    }
    return pieces;
}

} // namespace discretize
