#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "femoop/model/ids.h"
#include "femoop/shape/shape.h"

namespace femoop_test {

/// Elements of one shape between nodes.
struct PlaneMesh {
    femoop::ShapeKind shape = femoop::ShapeKind::T3;
    std::vector<Eigen::Vector2d> positions;
    std::vector<std::vector<femoop::NodeId>> elements;
};

struct ElementEdge {
    std::size_t element;
    int edge;
};

/// The unit square in nx x ny cells: quadrilaterals, or two triangles in each.
PlaneMesh unit_square_mesh(femoop::ShapeKind shape, int nx, int ny);

/// Moves every node, middle nodes too, so that curved sides follow.
PlaneMesh mapped(PlaneMesh mesh, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& map);

/// Whether middle nodes stay in the middle of their sides when nodes are shaken.
enum class Sides : std::uint8_t { Straight, Curved };
/// Moves the nodes inside by up to `reach`, each in its own way; those of the boundary stay.
PlaneMesh shaken(PlaneMesh mesh, double reach, Sides sides);

/// The edges that one element alone has.
std::vector<ElementEdge> boundary(const PlaneMesh& mesh);
std::vector<bool> is_on_boundary(const PlaneMesh& mesh); ///< by node

/// The shapes that elements have.
std::vector<femoop::ShapeKind> plane_shapes();

} // namespace femoop_test
