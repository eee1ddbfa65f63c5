#pragma once

#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/geometry/structure_shape.h"
#include "apps/drawing/pick.h"
#include "apps/drawing/sketch/sketch.h"
#include "apps/frame/document/document.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/tools/tool_controller.h"

namespace frame {

/// The place of the xy plane that is seen at a point of the sheet; nothing where the plane is seen edge-on.
std::optional<Eigen::Vector2d> place_in_plane(const Projection& projection, ui::Point at);

/// The pointer over a panel of the picture.
struct Pointer {
    ui::Point at; ///< on the sheet
    bool is_over = false;
    bool adds = false;     ///< Shift is held
    bool is_exact = false; ///< Alt is held: nothing draws the place to it
};

/// The place of the working plane that is seen at a point of the sheet; nothing where the plane is seen edge-on.
std::optional<Eigen::Vector3d> place_in_working_plane(const Projection& projection, const WorkingPlane& plane,
                                                      ui::Point at);

/// What the tool in the hand is told of the pointer. Places are drawn to the document that it works on.
/// \pre what is under the pointer is in that document
Aim aim_at(const Document& document, const ToolController& tool_controller, const Projection& projection,
           const Pointer& pointer, const Pick& under, const Grips& grips);

/// The distance of the grid's lines at this scale, where none was typed [length].
double grid_of(const Projection& projection);

} // namespace frame
