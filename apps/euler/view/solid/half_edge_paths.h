#pragma once

#include "apps/euler/view/solid/stations.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace euler {

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
    HalfEdgePaths(const topology::Solid& solid, const Stations& stations, const Sight& sight);

    /// From its start to its end, both included; one point of a lone vertex.
    std::vector<topology::Point> operator()(topology::HalfEdgeId h) const;
    bool is_curved(topology::HalfEdgeId h) const;

private:
    using Curve = std::vector<topology::Point>;
    void bend(topology::VertexId v);
    Curve curve(topology::VertexId v, double leaves_at, double returns_at) const;

    const topology::Solid& solid_;
    const Stations& stations_;
    const Sight& sight_;
    std::unordered_map<topology::EdgeId, Curve> curves_; ///< as the plus half runs
};

} // namespace euler
