#pragma once

#include <optional>
#include <vector>

#include "topology/planar/frame.h"

namespace euler {

/// A place on a drawn line where the figure has a vertex, or the free end of the line.
struct Stop {
    double along = 0.0; ///< 0 at the beginning of the line, 1 at its end
    std::optional<topology::VertexId> vertex;
};

/// A place where a drawn line meets the inside of an edge.
struct Crossing {
    topology::EdgeId edge;
    topology::Point point;
};

/// Where a straight line meets a figure in its plane, up to 1e-9 of the figure's extent.
class LineOnFigure {
public:
    /// The solid must outlive this.
    LineOnFigure(const topology::Solid& solid, const topology::Frame& frame, const topology::Point& from,
                 const topology::Point& to);

    /// The first one found: where the line crosses an edge, or an end lies in the middle of one. Not where there is a
    /// vertex, nor along an edge.
    std::optional<Crossing> crossing() const;
    std::vector<Stop> stops() const; ///< from the beginning on; both ends are among them

private:
    topology::FlatPoint flat(topology::VertexId v) const { return frame_.flat(solid_.point(v)); }
    double beside(const topology::FlatPoint& a, const topology::FlatPoint& b, const topology::FlatPoint& p) const;
    bool is_at(const topology::FlatPoint& a, const topology::FlatPoint& b) const;
    double along(const topology::FlatPoint& p) const;
    bool is_met(topology::VertexId v) const;
    std::optional<double> crossing(topology::HalfEdgeId h) const;
    bool is_inside(const topology::FlatPoint& p, topology::HalfEdgeId h) const;

    const topology::Solid& solid_;
    topology::Frame frame_;
    topology::Point from_, to_;
    topology::FlatPoint a_, b_; ///< the ends in the plane
    double tolerance_ = 0.0;
};

} // namespace euler
