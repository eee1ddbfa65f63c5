#pragma once

#include "apps/euler/view/solid/face_body.h"

#include <vector>

namespace euler {

/// The lines of half-edges, each inside its face beside its edge.
///
///        o<-----------o         Lines end where those of the next and the previous half-edge pass, so that a loop
///        |  <-------  |         reads as a chain of arrows; seen from inside they stand farther in, so that the two
///        | |        ^ |         sides of a thin solid differ. Both halves of a strut run beside it, one on each side.
///        | v        | |         A lone vertex's half-edge is a circle around it.
class ArrowLines {
public:
    ArrowLines(const topology::Solid& solid, const HalfEdgePaths& paths, const FaceBodies& bodies,
               const ViewTransform& transform, double symbol_scale);

    /// From tail to head; empty where there is no room for an arrow, less soon in a solid of thousands.
    std::vector<topology::Point> operator()(topology::HalfEdgeId h) const;

private:
    std::vector<topology::Point> circle(const topology::Point& middle) const;
    std::vector<topology::Point> straight(topology::HalfEdgeId h) const;
    std::vector<topology::Point> curved(std::vector<topology::Point> path) const;
    topology::Vector plane_normal(topology::FaceId f, const topology::Vector& along) const;
    double offset(topology::FaceId f) const;
    /// How much of the edge's end the neighbour's line takes, where the loop turns from `from` to `to`.
    static double taken(const topology::Vector& from, const topology::Vector& to, const topology::Vector& normal,
                        double offset);
    topology::Vector direction(topology::HalfEdgeId h) const;

    const topology::Solid& solid_;
    const HalfEdgePaths& paths_;
    const FaceBodies& bodies_;
    const ViewTransform& transform_;
    double symbol_scale_;
    double shortest_; ///< [px] of an edge that has arrows
};

/// Keeps the first part of a line, of `share` of its length.
void keep_share(std::vector<topology::Point>& line, double share);

} // namespace euler
