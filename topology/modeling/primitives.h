#pragma once

#include <cstdint>

#include "topology/geometry/vector.h"
#include "topology/halfedge/operators/euler_operator.h"

namespace topology {

/// Solids made by operators, each as one more shell, right side out: their volume is positive. Lengths in one unit.

/// A lamina and the face that a sweep moved away from it.
struct Prism {
    FaceId base, top;
};
Prism add_block(EulerOperator& op, const Point& corner, const Vector& size); ///< along the axes, from its least corner
Prism add_prism(EulerOperator& op, int n, double radius, double height);     ///< regular, about z, base in z = 0
FaceId add_cone(EulerOperator& op, int n, double radius, double height);     ///< a pyramid of n sides; returns its base
void add_sphere(EulerOperator& op, double radius, int n_meridians, int n_parallels); ///< n_parallels bands
struct TorusSize {
    double radius = 2.0; ///< of the circle through the tube's middle
    double tube = 1.0;
};
void add_torus(EulerOperator& op, const TorusSize& size, int n_around, int n_tube);

/// Sinks a pocket with this outline into a face, `by` deep, and, if `through` is given, opens it there: KFMRH of the
/// pocket's floor and the face that it reaches makes a handle. The outline is counter-clockwise seen from outside.
FaceId sink_pocket(EulerOperator& op, FaceId face, const std::vector<Point>& outline, const Vector& by);
void open_pocket(EulerOperator& op, FaceId floor, FaceId through);

/// A box-shaped void, as one more shell whose outside is its inside.
void add_void(EulerOperator& op, const Point& corner, const Vector& size);

enum class Platonic : std::uint8_t { Tetrahedron, Cube, Octahedron, Dodecahedron, Icosahedron };
/// About the origin; its corners are one unit from it.
Solid platonic(Platonic kind);

} // namespace topology
