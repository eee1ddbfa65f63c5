#pragma once

#include <vector>

#include "topology/planar/planar_figure.h"

namespace topology {

/// A box along the axes.
struct Box {
    Point least, most;

    void include(const Point& p);
    bool meets(const Box& other, double tolerance) const;
    bool holds(const Box& other, double tolerance) const;
};

/// A face as a region of its plane, seen from outside.
class FlatFace {
public:
    FlatFace(const Solid& solid, FaceId f, double tolerance);

    FaceId id() const { return f_; }
    const Box& box() const { return box_; }
    bool has_area() const { return has_area_; }
    double height(const Point& p) const { return dot(frame_.normal(), p - frame_.origin); } ///< to the outside
    double area(LoopId l) const { return figure().area(l); }
    /// The vertex that is farthest from the plane.
    VertexId farthest() const;
    /// Is a point of the plane inside the outer loop?
    bool surrounds(const Point& p) const { return figure().winding(solid_.outer(f_), frame_.flat(p)) != 0; }
    /// Is it in the region, and on none of its edges?
    bool holds(const Point& p) const;
    bool has(VertexId v) const;
    /// Do two edges of the face have a point in common that is not an end of both?
    bool do_meet(EdgeId a, EdgeId b) const;
    std::vector<EdgeId> edges() const; ///< each once

private:
    PlanarFigure figure() const { return {solid_, frame_}; }
    FlatPoint flat(VertexId v) const { return frame_.flat(solid_.point(v)); }
    double distance(const FlatPoint& p, HalfEdgeId h) const;

    const Solid& solid_;
    FaceId f_;
    double tolerance_;
    Frame frame_;
    Box box_;
    bool has_area_ = false;
};

} // namespace topology
