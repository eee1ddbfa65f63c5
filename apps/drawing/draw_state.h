#pragma once

#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/part.h"
#include "apps/drawing/results/locked_scale.h"
#include "femoop/model/ids.h"

#include <optional>
#include <vector>

namespace drawing {

/// What the cursor is over, or what is selected: drawn with a broad line below it.
struct Highlight {
    std::vector<femoop::NodeId> nodes;
    std::vector<femoop::MemberId> members;
    std::vector<DimensionPlace> dimensions{};
};

/// What of a picture changes from one moment to the next: where it is looked at from, what the hand is doing, and where
/// a motion has come to. Nothing of it is kept with a view.
struct DrawState {
    std::optional<Camera> camera; ///< fits the sheet when absent
    Highlight hover{}, selection{};
    double phase = 1.0; ///< share of the displacement that is drawn, -1 to 1: animation
    /// The scales of diagrams and displacements; those of the results drawn when absent.
    std::optional<LockedScale> locked_scale{};
};

} // namespace drawing
