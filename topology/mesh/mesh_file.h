#pragma once

#include <string>
#include <string_view>

#include "topology/mesh/mesh.h"

namespace topology {

/// Wavefront OBJ: `v x y z` and `f a b c ...`, also as a/t/n and counted from the end (-1); everything else is left
/// out. Object File Format: `OFF`, counts, points, polygons; colours are left out. \throws LineError with the line's
/// number
Mesh read_obj(std::string_view text);
Mesh read_off(std::string_view text);

/// Numbers with the fewest digits that read back the same. In OBJ a polygon of two points is a line element, of one a
/// point element.
std::string write_obj(const Mesh& mesh);
std::string write_off(const Mesh& mesh);

} // namespace topology
