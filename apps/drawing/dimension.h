#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "femoop/edit/place.h"
#include "femoop/model/model.h"

namespace drawing {

/// Along what a dimension line measures.
enum class DimensionDirection : std::uint8_t { Aligned, Horizontal, Vertical };

/// A dimension line, or a chain of them on one line, in the plane of a model:
///
///     |<-- 2 m -->|<---- 3 m ---->|     at `offset` from the first node, to the left of its direction: +x for a
///     |           |               |     horizontal line (so above), +y for a vertical one, from the first node to
///     A           B               C     the second for an aligned one
///
/// It measures between nodes, so it follows them wherever they are dragged. They are known by their names, as in the
/// file: the ids of femoop count on when a node goes.
/// \invariant two names or more, no two equal
struct DimensionLine {
    std::vector<std::string> nodes;
    DimensionDirection direction = DimensionDirection::Aligned;
    double offset = 0.0; ///< in the model's unit of length

    friend bool operator==(const DimensionLine&, const DimensionLine&) = default;
};

/// Where a dimension line lies in the plane of its model.
struct DimensionLayout {
    struct Mark {
        Eigen::Vector2d node, foot; ///< a node, and its place on the line
        double level = 0.0;         ///< along the line
    };
    Eigen::Vector2d along;   ///< unit vector
    std::vector<Mark> marks; ///< in their order along the line

    Eigen::Vector2d left() const { return {-along.y(), along.x()}; }
};

/// Nothing where a node is not there, or two that give the line its direction lie at one place.
std::optional<DimensionLayout> layout_of(const femoop::Model& model, const DimensionLine& dimension);

/// The offset of the line that runs through a place. Nothing where `layout_of` gives nothing.
std::optional<double> offset_through(const femoop::Model& model, const DimensionLine& dimension,
                                     const Eigen::Vector2d& place);

/// The direction that is meant by a hand at this place, for a line between two nodes: that across which it is seen from
/// the middle between them; never one in which both lie at one level.
DimensionDirection direction_meant(const femoop::Model& model, const DimensionLine& between,
                                   const Eigen::Vector2d& place);

/// The same line for nodes that are placed anew together: it lies on the same side of them.
DimensionLine placed(const DimensionLine& dimension, const femoop::Model& before, const femoop::Placement& placement);

} // namespace drawing
