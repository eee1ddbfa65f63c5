#pragma once

#include "apps/drawing/cut.h"
#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/geometry/structure_shape.h"
#include "apps/drawing/show.h"
#include "ui/paint/geometry.h"

#include <optional>

namespace drawing {

/// What lies under the cursor: a node, or a cut through a member, or nothing.
struct Pick {
    std::optional<femoop::NodeId> node;
    std::optional<Cut> cut;
    bool is_on_member = false; ///< the cursor touches it; false where only a value of it is read

    bool is_nothing() const { return !node && !cut; }
};

/// The nearest node within a few pixels of the cursor, else the nearest member; where the panel shows results a member
/// may be farther off, so that a value can be read at its ordinate. In space the nearer one to the eye wins where two
/// lie on one another.
Pick pick(const StructureShape& shape, const Projection& projection, ui::Point cursor, const ShowSet& shown);

} // namespace drawing
