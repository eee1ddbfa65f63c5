#pragma once

#include "ui/paint/mesh/mesh.h"

#include <array>
#include <span>

namespace ui {

enum class Border { Soft, Hard };

/// Adds the triangles of a filled polygon to the mesh, with a border that is soft over one pixel, or hard where the
/// colour is so pale that nobody can tell: it takes a third of the triangles.
/// Any polygon: convex, concave, or crossing, touching or retracing itself, where each of its loops is filled.
void add_fill(Mesh& mesh, std::span<const Point> polygon, Border border = Border::Soft);

/// Adds the area of the first loop without the others, which lie inside it, with a hard border. A map of thousands of
/// cells is filled while a frame lasts.
void add_region(Mesh& mesh, std::span<const std::vector<Point>> loops);

/// Adds a filled circle.
void add_disc(Mesh& mesh, Point center, double radius);

/// A polygon that crosses or touches itself, cut there into polygons that do not. Loops without area are left out, and
/// so are stretches that the outline runs forth and back, as a diagram does where it is zero.
std::vector<std::vector<Point>> simple_loops(std::span<const Point> polygon);

/// Ear clipping of a simple polygon, in either sense of rotation: n - 2 triangles of indices into it.
std::vector<std::array<std::uint32_t, 3>> triangulation(std::span<const Point> polygon);

/// Twice the area, positive when the polygon runs clockwise as seen (y down).
double twice_area(std::span<const Point> polygon);

} // namespace ui
