#pragma once

#include "apps/drawing/draw_options.h"
#include "apps/frame/document/companion/named_view.h"
#include "apps/frame/document/drawing_names.h"
#include "femoop/model/model.h"
#include "ui/canvas/plane_camera.h"

namespace frame {

/// Looks at the model as the view that was kept: what is shown, of which case or an envelope of which, how large. Where
/// the model lacks the view's load case the one that is shown stays. The region is left to who knows the sheet:
/// `camera_on`.
void look_as(DrawOptions& options, const NamedView& view, const femoop::Model& model);

/// The camera that shows the region as high as a panel.
ui::PlaneCamera camera_on(const Region& region, ui::Size panel);

} // namespace frame
