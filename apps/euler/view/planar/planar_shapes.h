#pragma once

#include "apps/euler/view/look.h"
#include "apps/euler/view/shapes/shapes.h"
#include "apps/euler/view/solid/placed_solid.h"
#include "ui/canvas/orbit_camera.h"
#include "ui/text/message.h"

#include <optional>
#include <span>
#include <vector>

namespace euler {

/// The same topology drawn in the plane, as Schlegel drew polyhedra: one face of every shell is taken for the outside
/// and fills a disc around the others, which lie within it; none crosses another. Positions count for nothing.
///
/// A part that hangs on the rest by a ring alone is drawn inside the ring's face. Of a shell with handles no such
/// drawing exists: a sentence says so.
class PlanarMap {
public:
    PlanarMap() = default;
    /// `outside` is the face to be taken for its shell; else the one with the most half-edges.
    explicit PlanarMap(std::span<const Subject> subjects, std::optional<Part> outside = std::nullopt);

    /// The map between this one and another while a step is on its way (layout_on_its_way.h). \param subjects  of the
    /// map \param others  of the other one \param share  1: it is this map
    PlanarMap on_its_way(std::span<const Subject> subjects, const PlanarMap& other, std::span<const Subject> others,
                         double share) const;

    /// The subjects are those of the map, with any marks. The camera looks from above; only how it pans and zooms
    /// counts.
    Shapes shapes(std::span<const Subject> subjects, const ui::OrbitCamera& camera, const Look& look) const;
    /// The camera that shows the whole drawing.
    ui::OrbitCamera fitted(ui::Size sheet) const;

private:
    std::vector<PlacedSolid::Layout> layouts_; ///< by subject
    std::vector<ui::Message> sentences_;       ///< why some are not drawn
};

} // namespace euler
