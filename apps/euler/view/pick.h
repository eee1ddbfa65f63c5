#pragma once

#include "apps/euler/view/shapes/shapes.h"

#include <optional>
#include <set>
#include <span>

namespace euler {

/// What the pointer asks for.
struct PickRequest {
    ui::Point at;
    std::set<topology::EntityKind> kinds; ///< which are meant; a loop is picked by one of its half-edges
    double reach = 1.0;                   ///< > 0, times the usual distance: larger for a finger or a projector
};

/// The entity at a place: a vertex before a half-edge, a half-edge before an edge, an edge before a face, each only if
/// its kind is meant. Of several the nearer to the pointer, where they are about as near the one in front; of faces the
/// front one that covers the place. Where only faces with no area are left, such as a lone vertex's, they are picked by
/// their half-edges.
std::optional<Part> pick(const Shapes& shapes, std::span<const Subject> subjects, const PickRequest& request);

/// The corner that the pointer means: at the vertex nearest to it, the half-edge that starts there whose place in its
/// face lies nearest to the pointer. None where no vertex is near.
///
///            \   x /        x the pointer: of the three corners at the vertex, the one between these edges
///             \   /
///              \ /
///               o-------
std::optional<Part> pick_corner(const Shapes& shapes, std::span<const Subject> subjects, const PickRequest& request);

} // namespace euler
