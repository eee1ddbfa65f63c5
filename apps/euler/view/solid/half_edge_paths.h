#pragma once

#include "apps/euler/view/solid/animated_positions.h"

#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace euler {

using Curve = std::vector<topology::Point>;
using Curves = std::unordered_map<topology::EdgeId, Curve>; ///< each as its plus half runs

/// The course of every half-edge in space: straight, or a curve in the sheet's plane where it comes back to the vertex
/// it starts from.
///
///          _____
///         /     \      The ends of such closed edges leave the vertex in the order of its fan, so nested ones are
///        (   o   )     drawn inside one another.
///         \__|__/
///            v
class HalfEdgePaths {
public:
    HalfEdgePaths(const topology::Solid& solid, const AnimatedPositions& positions, const ViewTransform& transform);
    HalfEdgePaths(const topology::Solid& solid, const AnimatedPositions& positions, const ViewTransform& transform,
                  Curves curves)
        : solid_(solid), positions_(positions), transform_(transform), curves_(std::move(curves))
    {}

    /// From its start to its end, both included; one point of a lone vertex.
    std::vector<topology::Point> operator()(topology::HalfEdgeId h) const;
    bool is_curved(topology::HalfEdgeId h) const;
    const topology::Point& start(topology::HalfEdgeId h) const { return positions_[solid_.start(h)]; }
    const topology::Point& end(topology::HalfEdgeId h) const { return positions_[solid_.end(h)]; }

private:
    void bend(topology::VertexId v);
    Curve curve(topology::VertexId v, double leaves_at, double returns_at) const;

    const topology::Solid& solid_;
    const AnimatedPositions& positions_;
    const ViewTransform& transform_;
    Curves curves_;
};

} // namespace euler
