#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "apps/plane/discretize/drawing.h"
#include "femoop/plane/model/plane_model.h"

namespace plane {

using PlaceLine = std::vector<Eigen::Vector2d>;

/// A face as lines: the outer one counter-clockwise first, then those of its holes.
struct OutlinedFace {
    std::optional<femoop::plane::RegionId> region;
    bool is_hole = false; ///< its entry leaves it empty
    std::vector<PlaceLine> loops;
    Eigen::Vector2d inside; ///< a place in it, well away from its edges
};

/// A piece of a curve from vertex to vertex, or along the edge of an element, in the direction of its curve.
struct OutlinedPiece {
    std::optional<femoop::plane::CurveId> curve; ///< none of a mesh's border that no curve names
    PlaceLine line;
    bool has_left_material = false, has_right_material = false;
    bool dangles = false; ///< the same face lies on both sides
};

/// Curves, faces and vertices of a plane model as straight lines, none of which strays further from its curve than the
/// tolerance [length].
struct PlateOutline {
    std::vector<OutlinedFace> faces;
    std::vector<OutlinedPiece> pieces; ///< curve by curve, in their order along it
    std::vector<Eigen::Vector2d> vertices;
    std::vector<femoop::NodeId> points; ///< of the model, that stand as vertices
};

PlateOutline outline_of(const discretize::Drawing& drawing, double tolerance);
/// Of a mesh: regions are what elements cover.
PlateOutline outline_of(const femoop::plane::PlaneModel& mesh, double tolerance);
/// Of a mesh whose nodes lie elsewhere. \param places  of all points
PlateOutline outline_of(const femoop::plane::PlaneModel& mesh, const PlaceLine& places, double tolerance);

/// The same with the pieces of a curve that go on from one another as one line: dashes run through.
PlateOutline joined(PlateOutline outline);

/// The side of an element: straight, or the parabola through its middle node.
PlaceLine flattened_side(const Eigen::Vector2d& from, const std::optional<Eigen::Vector2d>& middle,
                         const Eigen::Vector2d& to, double tolerance);

/// A stretch of a curve with material on the same sides throughout, in the curve's direction.
struct CurvePath {
    PlaceLine line;
    std::vector<double> s; ///< from the start of the curve, at each place
    double length = 0.0;   ///< of the whole curve
    bool has_left_material = false, has_right_material = false;

    struct Place {
        Eigen::Vector2d at;
        std::size_t part = 0; ///< of the line
    };
    Place at(double place) const; ///< \param place  length from the start of the curve
    double middle() const { return 0.5 * (s.front() + s.back()); }
    double extent() const { return s.back() - s.front(); }
    bool touches_material() const { return has_left_material || has_right_material; }

    /// Away from the material, at a part of the line: to the left where it lies on both sides.
    Eigen::Vector2d outward(std::size_t part) const;
};
std::vector<CurvePath> paths_of(const PlateOutline& outline, femoop::plane::CurveId curve);

} // namespace plane
