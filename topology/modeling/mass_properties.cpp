#include "topology/modeling/mass_properties.h"

namespace topology {

namespace {

/// The oriented triangles from a loop's first vertex to each of its edges; of a planar loop they sum up to what it
/// encloses.
template <class Triangle> void each_triangle(const Solid& solid, LoopId l, const Triangle& triangle)
{
    const Point& apex = solid.point(solid.start(solid.half_edge(l)));
    for (const HalfEdgeId h : solid.chain(l)) triangle(apex, solid.point(solid.start(h)), solid.point(solid.end(h)));
}

} // namespace

Vector area_vector(const Solid& solid, FaceId f)
{
    Vector sum{};
    for (const LoopId l : solid.loops(f))
        each_triangle(solid, l,
                      [&](const Point& a, const Point& b, const Point& c) { sum = sum + 0.5 * cross(b - a, c - a); });
    return sum;
}

MassProperties mass_properties(const Solid& solid)
{
    MassProperties sum;
    if (solid.is_empty()) return sum;
    const Point origin = solid.point(*solid.vertices().begin());
    Vector moment{};
    for (const FaceId f : solid.faces()) sum.area += length(area_vector(solid, f));
    for (const LoopId l : solid.loops())
        each_triangle(solid, l, [&](const Point& p, const Point& q, const Point& r) {
            const Vector a = p - origin, b = q - origin, c = r - origin;
            const double volume = dot(cross(a, b), c) / 6.0; // of the tetrahedron from the origin
            sum.volume += volume;
            moment = moment + (volume / 4.0) * (a + b + c);
        });
    sum.centroid = sum.volume == 0.0 ? origin : origin + (1.0 / sum.volume) * moment;
    return sum;
}

} // namespace topology
