#include "apps/plane/discretize/region_mesh.h"

namespace discretize {

using topology::FlatPoint;

FlatPoint place_on_edge(const topology::PlanarSubdivision& plane, topology::EdgeId edge, double share)
{
    const topology::CurvePart& part = plane.part(edge);
    const topology::Curve& curve = plane.curve(part.curve);
    if (!curve.is_straight()) return curve.at(curve.at_share(part.span, share));
    const topology::HalfEdgeId h = plane.solid().plus(edge);
    const FlatPoint a = plane.at(plane.solid().start(h)), b = plane.at(plane.solid().end(h));
    return a + share * (b - a);
}

} // namespace discretize
