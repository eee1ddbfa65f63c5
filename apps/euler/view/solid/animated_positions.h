#pragma once

#include "apps/euler/view/marks.h"
#include "apps/euler/view/solid/view_transform.h"
#include "topology/halfedge/solid.h"

#include <utility>
#include <vector>

namespace euler {

/// Where the vertices are drawn: where the solid has them, but for two cases.
///
/// A vertex that comes or goes with an edge stands on its way between that edge's other end and its own place.
/// The two ends of an edge that lie at one place are drawn apart on the sheet, or the edge could not be seen.
class AnimatedPositions {
public:
    AnimatedPositions(const topology::Solid& solid, const MarkTable& marks, const ViewTransform& transform);
    explicit AnimatedPositions(std::vector<topology::Point> points) : points_(std::move(points)), extent_(1.0) {}

    const topology::Point& operator[](topology::VertexId v) const { return points_[v.index]; }
    double extent() const { return extent_; } ///< the diagonal of the box around all; 0 at one point

private:
    void spread_null_edges(const topology::Solid& solid, const ViewTransform& transform);
    void move_partial(const topology::Solid& solid, const MarkTable& marks);

    std::vector<topology::Point> points_;
    double extent_;
};

/// The diagonal of the box around a solid's vertices.
double extent(const topology::Solid& solid);

} // namespace euler
