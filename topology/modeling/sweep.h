#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "topology/geometry/vector.h"
#include "topology/halfedge/operators/euler_operator.h"

namespace topology {

/// A side that a sweep made: the face over the half-edge that ran from `from` to `to`.
struct SweptSide {
    VertexId from, to;
    FaceId face;
};
/// A vertex and its image. A vertex that the face meets at several corners has as many images.
struct SweptVertex {
    VertexId from, image;
};
struct Sweep {
    std::vector<SweptVertex> vertices;
    std::vector<SweptSide> sides;
};

/// Translational sweep: moves a face and leaves a wall behind each of its edges.
///
///        o--------o                 o--------o'  f, moved
///        |    f   |     ->         /|       /|
///        |        |               o--------o |        of n corners: V+n E+2n F+n
///        o--------o               | side   | |
///                                 o--------o
///
/// Each corner grows a strut (MEV), two struts after each other are joined (MEF). The outer loop comes first, then the
/// rings, oldest first, each from its own half-edge onward. A lone vertex grows a strut alone.
/// Survive  f, as the moved face, and its rings; every old vertex and edge
/// Source   [Mantyla1988, program 12.3]
Sweep sweep(EulerOperator& op, FaceId f, const Vector& by);

/// The same with any motion: the images of the face's vertices are where `image` puts them.
using Motion = std::function<Point(const Point&)>;
Sweep sweep(EulerOperator& op, FaceId f, const Motion& image);

/// A loop of one closed edge has no second strut to join to; and f must live.
std::optional<Refusal> why_not_sweep(const EulerOperator& op, FaceId f);

} // namespace topology
