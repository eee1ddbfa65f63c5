#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// An element, and the size that it should have.
struct RefinedSize {
    Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< the mean of its corners
    double size = 0.0;   ///< as it is: of the sides of equilateral triangles with its area, a quadrilateral two of them
    double wanted = 0.0; ///< so measured
};

/// The degree of the polynomials that an element has all of: 1 of T3 and Q4, 2 of T6, Q8 and Q9. The error of a smooth
/// field is of the order of size^degree in energy, so of N^(-degree/2) with N unknowns in the plane.
int complete_degree(ShapeKind kind);

/// The sizes of elements for an error of the whole body that is aimed at, if every element has the same share of it:
///
///     h_new = h (eta ||u|| / (sqrt(n) ||e_i||))^(1/p)
///
///     eta            the error aimed at, over the norm of the whole: 0.05 is 5 %
///     ||e_i||/||u||  of each element, as PlaneCase::element_errors has them
///     n              elements of the mesh;  p  their complete degree
///
/// No element becomes less than a quarter or more than one and a half times as large: beside singular places the exponent
/// is too small, and what is gained there comes with the meshes that follow. Ratios of sizes are rounded to 1/1024, so
/// that every processor makes the same mesh.
///
/// Assumes  the error of an element goes with size^p, as it does where the exact stresses are smooth
/// Source   [ZienkiewiczTaylor2000, ch. 15]
std::vector<RefinedSize> refined_sizes(const PlaneModel& mesh, const std::vector<double>& element_errors, double eta);

/// About how many times as many elements a mesh of the wanted sizes has: the mean of (size / wanted)^2.
double growth_of_mesh(const std::vector<RefinedSize>& sizes);

} // namespace femoop::plane
