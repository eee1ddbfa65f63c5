#include "topology/embedding/flat_face.h"

#include <algorithm>
#include <cmath>

namespace topology {

void Box::include(const Point& p)
{
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
}

bool Box::meets(const Box& other, double tolerance) const
{
    const auto apart = [&](double high, double low) { return high + tolerance < low; };
    return !apart(most.x, other.least.x) && !apart(most.y, other.least.y) && !apart(most.z, other.least.z) &&
           !apart(other.most.x, least.x) && !apart(other.most.y, least.y) && !apart(other.most.z, least.z);
}

bool Box::holds(const Box& other, double tolerance) const
{
    Box both = *this;
    both.include(other.least);
    both.include(other.most);
    return length(both.least - least) <= tolerance && length(both.most - most) <= tolerance;
}

namespace {

/// Twice the area that the loop encloses, times the normal of the side that it is counter-clockwise from.
Vector twice_area(const Solid& solid, LoopId l)
{
    const Point& apex = solid.point(solid.start(solid.half_edge(l)));
    Vector sum;
    for (const HalfEdgeId h : solid.chain(l))
        sum = sum + cross(solid.point(solid.start(h)) - apex, solid.point(solid.end(h)) - apex);
    return sum;
}

} // namespace

FlatFace::FlatFace(const Solid& solid, FaceId f, double tolerance) : solid_(solid), f_(f), tolerance_(tolerance)
{
    const Point& first = solid.point(solid.start(solid.half_edge(solid.outer(f))));
    box_ = {first, first};
    for (const LoopId l : solid.loops(f))
        for (const HalfEdgeId h : solid.chain(l)) box_.include(solid.point(solid.start(h)));
    const Vector normal = twice_area(solid, solid.outer(f));
    has_area_ = length(normal) > tolerance * length(box_.most - box_.least);
    if (has_area_) frame_ = frame_across(first, normal);
}

VertexId FlatFace::farthest() const
{
    VertexId found = solid_.start(solid_.half_edge(solid_.outer(f_)));
    for (const LoopId l : solid_.loops(f_))
        for (const HalfEdgeId h : solid_.chain(l)) {
            const VertexId v = solid_.start(h);
            if (std::abs(height(solid_.point(v))) > std::abs(height(solid_.point(found)))) found = v;
        }
    return found;
}

double FlatFace::distance(const FlatPoint& p, HalfEdgeId h) const
{
    const FlatPoint a = flat(solid_.start(h)), b = flat(solid_.end(h));
    const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    const double along = square == 0.0 ? 0.0 : std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0);
    return std::hypot(p.x - a.x - along * x, p.y - a.y - along * y);
}

bool FlatFace::holds(const Point& p) const
{
    const FlatPoint at = frame_.flat(p);
    int turns = 0;
    for (const LoopId l : solid_.loops(f_)) {
        turns += figure().winding(l, at);
        for (const HalfEdgeId h : solid_.chain(l))
            if (distance(at, h) <= tolerance_) return false;
    }
    return turns != 0;
}

bool FlatFace::has(VertexId v) const
{
    for (const HalfEdgeId h : solid_.fan(v))
        if (solid_.face(h) == f_) return true;
    return false;
}

bool FlatFace::do_meet(EdgeId a, EdgeId b) const
{
    const HalfEdgeId h = solid_.plus(a), k = solid_.plus(b);
    const auto touches = [&](VertexId v, HalfEdgeId edge) {
        return v != solid_.start(edge) && v != solid_.end(edge) && distance(flat(v), edge) <= tolerance_;
    };
    if (touches(solid_.start(h), k) || touches(solid_.end(h), k) || touches(solid_.start(k), h) ||
        touches(solid_.end(k), h))
        return true;
    const FlatPoint p = flat(solid_.start(h)), q = flat(solid_.end(h)), r = flat(solid_.start(k)),
                    s = flat(solid_.end(k));
    return turn(p, q, r) * turn(p, q, s) < 0.0 && turn(r, s, p) * turn(r, s, q) < 0.0;
}

std::vector<EdgeId> FlatFace::edges() const
{
    std::vector<EdgeId> all;
    for (const LoopId l : solid_.loops(f_))
        for (const HalfEdgeId h : solid_.chain(l))
            if (const auto e = solid_.edge(h)) all.push_back(*e);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

} // namespace topology
