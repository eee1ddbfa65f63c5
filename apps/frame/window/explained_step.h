#pragma once

#include <vector>

#include "apps/drawing/draw_state.h"
#include "apps/drawing/structure/node_numbers.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/session/commands.h"

namespace frame {

/// The step of the derivation that the panel shows; null where it shows none, or has not followed the document yet.
const femoop::derivation::Step* explained_step(const Workspace& workspace);

/// The places in K of the degrees of freedom of every node that has any, held ones as 0; none while no number is
/// explained.
std::vector<NodeNumbers> node_numbers(const Workspace& workspace);

/// Adds the member or the node that this step speaks of, as far as it is in the picture.
void light_step(Highlight& highlight, const Workspace& workspace);

} // namespace frame
