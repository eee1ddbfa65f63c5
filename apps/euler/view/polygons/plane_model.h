#pragma once

#include "apps/euler/view/look.h"
#include "apps/euler/view/shapes/shapes.h"
#include "ui/canvas/plane_camera.h"

#include <span>

namespace euler {

/// The plane model of solids: every face for itself, every loop a polygon, with a side for each of its half-edges.
///
///       v4---e3---v3       Sides of the same edge have the same colour, and run against each other; gluing them makes
///        |        |        the surface. It shows what no picture in space or in the plane does: closed edges, lone
///       e4   f1  e2        vertices, struts and handles, whatever the genus. Rings are polygons within their face's
///        |        |        outer one; a loop of one half-edge is a circle, a lone vertex a dot.
///       v1---e1---v2
///
/// Source   M. Mantyla, An Introduction to Solid Modeling, chapter 3: plane models
Shapes plane_model(std::span<const Subject> subjects, const ui::PlaneCamera& camera, const Look& look);

/// The camera that shows all polygons.
ui::PlaneCamera fitted_plane_model(std::span<const Subject> subjects, ui::Size sheet);

} // namespace euler
