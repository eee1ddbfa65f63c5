#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/element/continuum/element_geometry.h"
#include "femoop/plane/mesh/edge_table.h"
#include "femoop/plane/model/field.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

Eigen::Vector2d position(const PlanePoint& point);
std::vector<Eigen::Vector2d> positions(const PlaneModel& model);                  ///< of all points, by their ids
NodePositions positions_of(const PlaneModel& model, const PlaneElement& element); ///< \pre has_points
/// The diagonal of the box around the places; 0 where there are none.
double extent(const std::vector<Eigen::Vector2d>& places);
double extent(const NodePositions& X);

/// Whether an outline that leaves one direction for another has a corner: it turns by 60 degrees or more.
bool is_corner(const Eigen::Vector2d& before, const Eigen::Vector2d& behind);

/// A node of a curve: how far along it lies, and in which direction the curve runs there. Where the curve has a
/// corner (`is_corner`) it has two directions, elsewhere the mean of those before and behind.
struct CurveNode {
    NodeId node;
    double s = 0.0;
    std::vector<Eigen::Vector2d> directions; ///< unit vectors; one, or two at a corner
};

/// A curve as its elements' edges draw it.
class CurveGeometry {
public:
    CurveGeometry(const PlaneModel& model, const std::vector<CurveEdge>& edges,
                  const std::optional<CurveReach>& reach = {});

    double length() const { return length_; }                      ///< of the whole curve, as it was drawn
    const std::vector<CurveNode>& nodes() const { return nodes_; } ///< as `nodes_along` lists them
    /// The length from the curve's start to a place of an edge, xi from -1 at its start to 1 at its end.
    double s(std::size_t edge, double xi) const;
    Eigen::Vector2d at(std::size_t edge, double xi) const;

private:
    using EdgePositions = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, 3, 2>;
    Eigen::Vector2d tangent(std::size_t edge, double xi) const; ///< d(x, y) / d xi
    void add_nodes(const std::vector<CurveEdge>& edges);

    std::vector<EdgePositions> edges_;
    std::vector<double> starts_; ///< of each edge
    double length_ = 0.0;
    std::vector<CurveNode> nodes_;
};

} // namespace femoop::plane
