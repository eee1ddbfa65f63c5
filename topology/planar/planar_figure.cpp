#include "topology/planar/planar_figure.h"

#include <cmath>
#include <numbers>

namespace topology {

double PlanarFigure::area(LoopId l) const
{
    const FlatPoint first = flat(solid_.start(solid_.half_edge(l)));
    double twice = 0.0;
    for (const HalfEdgeId h : solid_.chain(l)) twice += term(first, h);
    return 0.5 * twice;
}

double PlanarFigure::area(FaceId f) const
{
    double sum = 0.0;
    for (const LoopId l : solid_.loops(f)) sum += area(l);
    return sum;
}

FaceId PlanarFigure::unbounded() const
{
    FaceId least = *solid_.faces().begin();
    for (const FaceId f : solid_.faces())
        if (area(f) < area(least)) least = f;
    return least;
}

double PlanarFigure::area(HalfEdgeId from, HalfEdgeId to) const
{
    const FlatPoint first = flat(solid_.start(from));
    double twice = 0.0;
    HalfEdgeId h = from;
    do {
        twice += term(first, h);
        h = solid_.next(h);
    } while (h != to);
    return 0.5 * twice; // the closing edge ends at `first`
}

int PlanarFigure::winding(LoopId l, const FlatPoint& p) const
{
    int turns = 0;
    for (const HalfEdgeId h : solid_.chain(l)) {
        const FlatPoint a = flat(solid_.start(h)), b = flat(solid_.end(h));
        if (a.y <= p.y && b.y > p.y && turn(a, b, p) > 0.0) ++turns; // upward, on the right of p
        if (a.y > p.y && b.y <= p.y && turn(a, b, p) < 0.0) --turns;
    }
    return turns;
}

FaceId PlanarFigure::face_at(const FlatPoint& p) const
{
    for (const FaceId f : solid_.faces()) {
        int turns = 0;
        for (const LoopId l : solid_.loops(f)) turns += winding(l, p);
        if (turns > 0) return f;
    }
    return unbounded();
}

HalfEdgeId PlanarFigure::corner(VertexId v, const FlatPoint& toward) const
{
    constexpr double full = 2.0 * std::numbers::pi;
    const FlatPoint at = flat(v);
    const double wanted = std::atan2(toward.y - at.y, toward.x - at.x);
    HalfEdgeId best = solid_.half_edge(v);
    double least = full;
    for (const HalfEdgeId h : solid_.fan(v)) {
        const FlatPoint end = flat(solid_.end(h));
        double clockwise = wanted - std::atan2(end.y - at.y, end.x - at.x);
        if (clockwise < 0.0) clockwise += full;
        if (clockwise < least) {
            least = clockwise;
            best = h;
        }
    }
    return best;
}

} // namespace topology
