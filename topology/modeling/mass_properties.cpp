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
    std::vector<FaceId> faces;
    for (const FaceId f : solid.faces()) faces.push_back(f);
    return mass_properties(solid, faces);
}

MassProperties mass_properties(const Solid& solid, const std::vector<FaceId>& faces)
{
    MassProperties sum;
    if (faces.empty()) return sum;
    const Point origin = solid.point(solid.start(solid.half_edge(solid.outer(faces.front()))));
    Vector moment{};
    const auto add = [&](const Point& p, const Point& q, const Point& r) {
        const Vector a = p - origin, b = q - origin, c = r - origin;
        const double volume = dot(cross(a, b), c) / 6.0; // of the tetrahedron from the origin
        sum.volume += volume;
        moment = moment + (volume / 4.0) * (a + b + c);
    };
    for (const FaceId f : faces) {
        sum.area += length(area_vector(solid, f));
        for (const LoopId l : solid.loops(f)) each_triangle(solid, l, add);
    }
    sum.centroid = sum.volume == 0.0 ? origin : origin + (1.0 / sum.volume) * moment;
    return sum;
}

} // namespace topology
