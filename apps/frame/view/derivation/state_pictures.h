#pragma once

#include <cstddef>
#include <vector>

#include "apps/drawing/draw_options.h"
#include "apps/frame/document/drawing_names.h"
#include "femoop/methods/derivation/derivation.h"
#include "femoop/methods/force_method/force_method.h"
#include "ui/paint/geometry.h"
#include "ui/paint/painter.h"

namespace frame {

/// How states are drawn.
struct StateLook {
    const DrawOptions& view;              ///< theme, language, units and the side of moments
    const femoop::derivation::Step& step; ///< that is shown: its state is told by a bold name
};

/// A state of the force method and where it stands: state 0 of the loads, one for each redundant, and their sum.
struct StateCell {
    std::size_t state = 0; ///< one more than there are redundants: the sum
    ui::Box picture;
    ui::Box name; ///< below it
};

/// So many side by side, as large as they can be; where they would be too small to be read, the one that the step speaks
/// of alone.
std::vector<StateCell> state_cells(const femoop::force_method::ForceMethod& method, ui::Size room,
                                   const StateLook& look);

/// Draws the primary structure in one state on the painter's whole sheet: what loads it, and its moments (of a truss its
/// axial forces), or those of the sum.
void draw_state(ui::Painter& painter, const femoop::force_method::ForceMethod& method, std::size_t state,
                const StateLook& look);
/// Its name likewise, shorter where it has no room.
void draw_state_name(ui::Painter& painter, const femoop::force_method::ForceMethod& method, std::size_t state,
                     const StateLook& look);

} // namespace frame
