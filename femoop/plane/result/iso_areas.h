#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/plane/result/triangulated_field.h"

namespace femoop::plane {

/// A closed line; counter-clockwise where it is the outside of an area, clockwise where it is that of a hole.
using IsoLoop = std::vector<Eigen::Vector2d>;
double area(const IsoLoop& loop); ///< positive where it runs counter-clockwise

/// An area with its holes.
struct IsoArea {
    IsoLoop outside;
    std::vector<IsoLoop> holes;
};

/// Where a field is not less than the level: areas whose borders are lines of equal value, borders of the mesh, and
/// borders of elements where the field jumps over the level. What lies between two levels is the difference of two such
/// sets; drawn one over the other from the least level on they need not be subtracted, and show no seams.
///
/// Method  each triangle that the level crosses has one straight piece of the line; borders are walked with the area to
///         the left, from piece to piece by twins, so that nothing is searched for by its place. A corner whose value is
///         the level counts as above it
/// Speed   linear in the triangles: 200 000 with ten levels take less than 50 ms
std::vector<IsoArea> areas_above(const TriangulatedField& field, double level);
/// The same as bare loops, not sorted into outsides and holes: their areas sum to that of the set.
std::vector<IsoLoop> loops_above(const TriangulatedField& field, double level);

/// Lines of equal value, each as long as it can be; closed ones end where they began. They run with the larger values to
/// their left, and end where the field jumps.
std::vector<std::vector<Eigen::Vector2d>> iso_lines(const TriangulatedField& field, double level);

} // namespace femoop::plane
