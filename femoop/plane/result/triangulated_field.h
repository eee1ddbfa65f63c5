#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "femoop/plane/analysis/plane_results.h"
#include "femoop/plane/mesh/locator.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// A number at every place of a mesh as triangles on which it is linear: what bands and lines of equal value are made
/// of. Neighbours share corners, yet each has values of its own there, so that a field may jump between them.
///
///          c2            half-edge 3 t + k of the triangle t runs from its corner k to the next one; the
///       2 /  | 1         triangle, whose corners run counter-clockwise, lies to its left
///        /   |
///      c0 -- c1
///         0
struct TriangulatedField {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::vector<Eigen::Vector2d> places;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< places of corners
    std::vector<std::array<double, 3>> values;           ///< at corners, parallel to the triangles
    std::vector<std::uint32_t> twins;                    ///< of half-edges: that of the neighbour, or none
    std::vector<std::uint32_t> ends; ///< half-edges where the field ends or jumps; twins and these are found by `join`

    std::vector<Location> located; ///< of places: in one of the elements that have it; empty where there is no mesh

    static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    std::uint32_t start(std::uint32_t h) const { return triangles[h / 3][h % 3]; }
    double start_value(std::uint32_t h) const { return values[h / 3][h % 3]; }
    double end_value(std::uint32_t h) const { return start_value(next(h)); }
    /// Does it go on in the neighbour with the same values?
    bool is_continuous(std::uint32_t h) const
    {
        const std::uint32_t twin = twins[h];
        return twin != none && start_value(h) == end_value(twin) && end_value(h) == start_value(twin);
    }
    double area() const;
};

/// Finds the twins of all half-edges by their places, and the ends. Where more than two meet, some have none.
void join(TriangulatedField& field);

/// Into how many parts the sides of elements are cut, so that curves look like curves on a coarse mesh; 0: corners, middle
/// nodes and a centre alone. It is less the more elements there are.
int parts_of_sides(const PlaneModel& mesh);

/// \param parts  of sides  \param value  at a place of an element
TriangulatedField triangulated(const PlaneModel& mesh, int parts, const std::function<double(const Location&)>& value);

/// A component over the mesh: of stresses by the reading, of strains smoothed, of displacements. \pre the reading is not
/// that of Gauss points
TriangulatedField component_field(const PlaneCase& result, PlaneComponent component, StressReading reading);
/// The value that it has at a place of an element.
double component_at(const PlaneCase& result, PlaneComponent component, StressReading reading, const Location& place);

/// The least and the largest over nodes, each region's value, as `extreme` gives them for stresses.
struct FieldExtremes {
    PlaneExtreme min, max;
};
FieldExtremes field_extremes(const PlaneCase& result, PlaneComponent component, StressReading reading);

} // namespace femoop::plane
