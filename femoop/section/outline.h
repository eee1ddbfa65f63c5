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

/// A side of a cross-section's boundary: straight, or an arc of at most a quarter turn that goes neither past the top
/// or bottom nor past the left or right of its circle.
struct OutlineSide {
    OutlinePoint from{}, to{};
    std::optional<OutlinePoint> centre{}; ///< of an arc
    int pieces = 1;                       ///< that a picture draws it in

    friend bool operator==(const OutlineSide&, const OutlineSide&) = default;
};

/// The outline of a cross-section in its own axes about the centroid.
///
///        y' ^  ============      looking along +x', y' is up and z' points right
///           |       ||
///           o---> z'            sides and `outer` run counter-clockwise as seen, a hole clockwise
///
/// For pictures circles are polygons of 72 sides and root radii of rolled profiles arcs of six. The flanges of UPN
/// taper as their standard says: 8 % up to UPN 300, 5 % beyond, with root radius r and toe radius r/2; L has those radii
/// too, and the corners of SHS and RHS are rounded by 1.5 t outside and t inside.
struct SectionOutline {
    std::vector<OutlineSide> sides; ///< the figure as it is, of a hole too
    std::vector<OutlinePoint> outer;
    std::vector<OutlinePoint> hole; ///< of a tube or a box, else empty
    double top = 0.0, bottom = 0.0; ///< y' of the extreme fibres
    double left = 0.0, right = 0.0; ///< z' of the sides
    double height() const { return top - bottom; }
    double width() const { return right - left; }
};

/// Turned by 90 degrees counter-clockwise.
SectionOutline turned(const SectionOutline& upright);

/// In the unit of the shape's dimensions. \pre `why_not(shape)` has nothing to say \throws std::invalid_argument
SectionOutline outline(const SectionShape& shape);

/// In the model's unit of length, turned where the section is; nothing for a section that is given by numbers alone, or by a profile or a shape that
/// cannot be.
std::optional<SectionOutline> outline(const Section& section, const Units& units);

} // namespace femoop
