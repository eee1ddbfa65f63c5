#pragma once

#include "apps/euler/view/look.h"
#include "apps/euler/view/shapes/shapes.h"
#include "ui/canvas/plane_camera.h"

#include <span>
#include <vector>

namespace euler {

/// A step on its way: the same solids as they were before it, where the drawn ones are after it, or the other way.
struct PlaneStep {
    std::vector<Subject> other{}; ///< none at rest
    double share = 1.0;           ///< of the drawn solids' own places; 0: everything stands where the others have it
};

/// The plane model of solids: every face for itself, every loop a polygon, with a side for each of its half-edges.
///
///       v4---e3---v3       Sides of the same edge have the same colour, and run against each other; gluing them makes
///        |        |        the surface. It shows what no picture in space or in the plane does: closed edges, lone
///       e4   f1  e2        vertices, struts and handles, whatever the genus. Rings are polygons within their face's
///        |        |        outer one; a loop of one half-edge is a circle, a lone vertex a dot.
///       v1---e1---v2
///
/// While a step is on its way each side moves from the polygon of the one state to that of the other.
///
/// Source   [Mantyla1988, ch. 3], plane models
Shapes plane_model(std::span<const Subject> subjects, const ui::PlaneCamera& camera, const Look& look,
                   const PlaneStep& step = {});

/// The camera that shows all polygons.
ui::PlaneCamera fitted_plane_model(std::span<const Subject> subjects, ui::Size sheet, const PlaneStep& step = {});

} // namespace euler
