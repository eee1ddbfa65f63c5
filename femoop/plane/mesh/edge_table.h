#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// An edge of an element, which has the element to its left.
struct ElementEdge {
    ElementId element;
    int edge = 0; ///< of the element's shape
};

/// The edges of all elements, found by their corners. Elements with a wrong number of points, or with points that are
/// not there, have none.
class EdgeTable {
public:
    explicit EdgeTable(const PlaneModel& model);

    /// The edge that some element has from `start` to `end`, that element to its left.
    std::optional<ElementEdge> find(NodeId start, NodeId end) const;

private:
    struct Entry {
        NodeId end;
        ElementEdge edge;
    };
    std::vector<std::uint32_t> first_; ///< of each node the first entry that starts there
    std::vector<Entry> entries_;
};

/// A piece of a curve: an edge with the elements on both its sides, seen in the curve's direction.
struct CurveEdge {
    NodeId start, end;
    std::optional<NodeId> middle;
    std::optional<ElementEdge> left, right; ///< at least one; the right one runs against the curve
    bool begins_run = false;                ///< the curve's first one, or there is none between it and the one before
};

struct CurveEdges {
    std::vector<CurveEdge> edges;
    std::optional<std::size_t> gap; ///< index of the point after which no element has an edge
};

/// The edges along a curve, until one is missing.
CurveEdges edges_along(const PlaneModel& model, const EdgeTable& table, const PlaneCurve& curve);

/// The nodes of a curve in its direction, middle nodes in their places; a closed curve has its first node once.
std::vector<NodeId> nodes_along(const std::vector<CurveEdge>& edges);

/// Does an element have its points, all of them there?
bool has_points(const PlaneModel& model, const PlaneElement& element);

} // namespace femoop::plane
