#pragma once

#include "ui/paint/mesh/mesh.h"
#include "ui/paint/surface.h"

#include <span>

namespace ui {

/// A line's look in physical pixels, without its dashes.
struct StrokeShape {
    double width = 1.0;
    Cap cap = Cap::Butt;
    Join join = Join::Miter;
};

/// Adds the triangles of a solid line to the mesh: a strip of ribs, each from the left border to the right one.
///
///     left  o-----o---.          A line thinner than a pixel is drawn one pixel wide and paler.
///           |  \  |  \ \         At a corner the inner side is mitred, the outer one mitred, rounded or
///     right o-----o----o         bevelled by more ribs; nothing is covered twice unless the line's
///                                pieces are shorter than the corner.
void add_stroke(Mesh& mesh, std::span<const Point> points, PathEnds ends, const StrokeShape& shape);

/// The drawn stretches of a dashed line, each an open polyline. Lengths in the points' unit.
/// At most 100 000 of them; what would follow is left out.
std::vector<std::vector<Point>> dashes_of(const Path& path, const DashPattern& pattern);

} // namespace ui
