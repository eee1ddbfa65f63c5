#pragma once

#include <optional>
#include <vector>

#include "femoop/model/property.h"
#include "femoop/model/quantity/units.h"

namespace femoop {

struct OutlinePoint {
    double y = 0.0, z = 0.0;

    friend bool operator==(const OutlinePoint&, const OutlinePoint&) = default;
};

/// The outline of a cross-section in its own axes about the centroid, for pictures.
///
///        y' ^  ============      looking along +x', y' is up and z' points right
///           |       ||
///           o---> z'            `outer` runs counter-clockwise as seen, a hole clockwise
///
/// Circles are polygons of 72 sides, root radii of rolled profiles arcs of six; the flanges of UPN do not taper, so a
/// profile's centroid is that of the outline and within a few percent of the table's.
struct SectionOutline {
    std::vector<OutlinePoint> outer;
    std::vector<OutlinePoint> hole; ///< of a tube or a box, else empty
    double top = 0.0, bottom = 0.0; ///< y' of the extreme fibres
    double left = 0.0, right = 0.0; ///< z' of the sides
    double height() const { return top - bottom; }
    double width() const { return right - left; }
};

/// In the unit of the shape's dimensions. \pre `why_not(shape)` has nothing to say \throws std::invalid_argument
SectionOutline outline(const Shape& shape);

/// In the model's unit of length; nothing for a section that is given by numbers alone, or by a profile or a shape that
/// cannot be.
std::optional<SectionOutline> outline(const Section& section, const Units& units);

} // namespace femoop
