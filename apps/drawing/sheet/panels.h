#pragma once

#include "apps/drawing/draw_options.h"
#include "femoop/model/model.h"
#include "ui/paint/geometry.h"

#include <vector>

namespace drawing {

struct InfluencePicture;

/// A part of the sheet with a picture of the structure.
struct Panel {
    ui::Box box;
    ShowSet show;                           ///< what this one shows
    const InfluencePicture* line = nullptr; ///< that it shows in place of the input's; null: none of its own
};

/// How a sheet is divided: one picture with everything, or the loads first (alone, or with the first of the results) and
/// then one panel per result.
struct PanelRequest {
    ShowSet show;
    Layout layout = Layout::Automatic;
    bool has_results = false; ///< without them there is one panel
};
/// What each panel shows. A truss worked out by hand and a funicular have two: the structure, and the joint or the
/// diagram; so has virtual work: the structure under its loads, and under the unit load.
std::vector<ShowSet> panel_contents(const PanelRequest& request);

/// It shows forces alone, to their own scale, and not the structure.
inline bool is_diagram(const Panel& panel)
{
    return panel.show.contains(Show::Truss) || panel.show.contains(Show::ForcePolygon);
}

/// Panels of one size, row by row. \pre columns > 0
std::vector<Panel> panels(const std::vector<ShowSet>& contents, const ui::Box& area, std::size_t columns);

} // namespace drawing
