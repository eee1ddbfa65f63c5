#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "topology/geometry/flat_point.h"

namespace topology {

/// A node of a mesh of cells, counted from 0.
using CellNode = std::uint32_t;
using CellEdge = std::array<CellNode, 2>;

/// Where cells are wanted: inside a closed chain of nodes and outside others. Its nodes and their chains stay in every
/// mesh as they are.
struct MeshDomain {
    std::vector<FlatPoint> nodes;             ///< in loops, in segments, and by themselves
    std::vector<std::vector<CellNode>> loops; ///< the first counter-clockwise around the others, those clockwise
    std::vector<CellEdge> segments;           ///< inside, edges of cells too
    /// Where elements have edges that bend, the place in the middle of one. Quadrilaterals are judged with them.
    struct Bend {
        CellEdge edge{};
        FlatPoint middle;
    };
    std::vector<Bend> bends{};

    double area() const;                 ///< as the chords of the loops have it
    std::vector<CellEdge> edges() const; ///< of loops in their direction, then segments
    /// The length of edges that is wanted at each node: the mean of what it has, but no more than `size` unless that is 0,
    /// and than the node's own one of `wanted` where this is above 0. Infinite where nothing limits it.
    std::vector<double> sizes(double size, const std::vector<double>& wanted) const;
};

/// A triangle or a quadrilateral, counter-clockwise.
class Cell {
public:
    Cell(CellNode a, CellNode b, CellNode c) : nodes_{a, b, c, c}, n_(3) {}
    Cell(CellNode a, CellNode b, CellNode c, CellNode d) : nodes_{a, b, c, d} {}

    std::span<const CellNode> nodes() const { return {nodes_.data(), n_}; }
    bool is_triangle() const { return n_ == 3; }
    friend bool operator==(const Cell&, const Cell&) = default;

private:
    std::array<CellNode, 4> nodes_;
    std::uint8_t n_ = 4;
};

/// Cells and their nodes: those of the domain first, with the same numbers.
struct CellMesh {
    std::vector<FlatPoint> nodes;
    std::vector<Cell> cells;
};

/// Two edges of a domain that cross or touch where neither ends, a node that lies on an edge, an edge twice or between a
/// node and itself, a loop on the wrong side of others: nothing can be meshed.
struct CrossingEdges : std::runtime_error {
    CrossingEdges(const CellEdge& a, const CellEdge& b) : runtime_error("edges of the boundary cross"), edges{a, b} {}
    std::array<CellEdge, 2> edges;
};

} // namespace topology
