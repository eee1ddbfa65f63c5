#pragma once

#include <optional>

#include "apps/plane/view/plate_picture.h"
#include "apps/plane/view/probe_values.h"

namespace plane {

/// What one probe reads, beside the drawing: values smoothed beside those of elements, and Mohr's circle below.
struct ProbePanel {
    Eigen::Vector2d at;
    std::size_t n = 1;               ///< the n-th probe, counted from 1
    bool has_results = true;         ///< to be read
    std::optional<ProbeState> state; ///< nothing where no material is
};

inline constexpr double least_probe_panel = 234.0; ///< [px] that its type can be read in
/// How wide the panel is on a sheet as wide.
double probe_panel_width(const ui::Theme& theme, double sheet_width);

/// \param frame  the scales of the circle; those that fit it when absent
void draw_probe_panel(ui::Painter& painter, const ProbePanel& panel, const PlateOptions& options,
                      const ui::DisplayUnits& units, const std::optional<mohr::Frame>& frame, const ui::Box& box);

} // namespace plane
