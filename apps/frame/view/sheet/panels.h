#pragma once

#include "apps/frame/view/view_options.h"
#include "femoop/model/model.h"
#include "ui/paint/geometry.h"

#include <vector>

namespace frame {

/// A part of the sheet with a picture of the structure.
struct Panel {
    ui::Box box;
    ShowSet show; ///< what this one shows
};

/// How a sheet is divided: one picture with everything, or the loads first and then one panel per result, as large as
/// the structure's shape allows.
/// \param has_results  without them there is one panel
/// \param aspect       width over height of the structure as it is seen
struct PanelRequest {
    ShowSet show;
    Layout layout = Layout::Automatic;
    bool has_results = false;
    ui::Box area;
    double aspect = 1.0;
    double border = 1.0; ///< factor for the room that loads and supports take around the structure
};
std::vector<Panel> panels(const PanelRequest& request);

} // namespace frame
