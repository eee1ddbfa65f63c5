#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "topology/geometry/point.h"
#include "topology/halfedge/solid.h"
#include "topology/text/line_error.h"

namespace topology {

/// A surface as files know it: points, and polygons that name them by index, counter-clockwise seen from outside.
struct Mesh {
    std::vector<Point> points;
    std::vector<std::vector<std::uint32_t>> polygons;
};

/// What is wrong with a mesh file or with the surface in it. The sentence of each stands in mesh.cpp.
enum class MeshFault : std::uint8_t {
    BadNumber, ///< {0}
    BadIndex,  ///< {0}
    NoHeader,  ///< OFF
    TooFewWords,
    TooShort, ///< {0} polygon
    NoPolygons,
    CutOff,
    SameDirection, ///< {0}, {1} points
    OpenEdge,      ///< {0}, {1} points
    PinchedPoint,  ///< {0}
};
inline constexpr int n_mesh_faults = 10;
std::string_view pattern(MeshFault fault); ///< English, with places {0} {1}
LineError error(MeshFault fault, const std::vector<std::string>& words);

/// The closed surface as a solid; vertex i is the i-th point that a polygon names, face i the i-th polygon. An edge may
/// lie twice in one polygon, once each way.
/// \throws LineError where the surface is open, turns its sides, or meets itself at a point
Solid solid_of(const Mesh& mesh);

/// The faces as polygons. Rings are joined to their face's outer loop by an edge between the two nearest vertices,
/// since polygons of files have no holes; a loop of one or two half-edges gives a polygon of one or two points.
Mesh mesh_of(const Solid& solid);

} // namespace topology
