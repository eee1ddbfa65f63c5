#pragma once

#include <vector>

#include "topology/planar/frame.h"

namespace topology {

/// A solid that lies in a plane, as a figure drawn there: its bounded faces are regions, counter-clockwise, and one
/// face is all that is around them. Edges are straight and cross nowhere.
///
///    +-----------+
///    | f2   +--+ |     f1 around     loops of a bounded face: the outer one counter-clockwise, its rings clockwise;
///    |      |f3| |                   all loops of the unbounded face run clockwise, about what they go around
///    |      +--+ |
///    +-----------+
class PlanarFigure {
public:
    /// Both must outlive the figure.
    PlanarFigure(const Solid& solid, const Frame& frame) : solid_(solid), frame_(frame) {}

    FlatPoint flat(VertexId v) const { return frame_.flat(solid_.point(v)); }
    double area(LoopId l) const; ///< positive where the loop runs counter-clockwise
    double area(FaceId f) const; ///< the sum of its loops', so that the unbounded face's is not positive
    FaceId unbounded() const;

    /// How often the loop runs around the point, counter-clockwise.
    int winding(LoopId l, const FlatPoint& p) const;
    /// The face that the point lies in. \pre it lies on no edge
    FaceId face_at(const FlatPoint& p) const;
    /// The corner at v that a line to the point would leave from. \pre no edge at v runs that way
    HalfEdgeId corner(VertexId v, const FlatPoint& toward) const;
    /// The area that a loop would have if an edge led from the corner `to` back to the corner `from` of one loop.
    double area(HalfEdgeId from, HalfEdgeId to) const;

private:
    /// Of the triangle with the first point, twice.
    double term(const FlatPoint& first, HalfEdgeId h) const
    {
        return turn(first, flat(solid_.start(h)), flat(solid_.end(h)));
    }

    const Solid& solid_;
    const Frame& frame_;
};

} // namespace topology
