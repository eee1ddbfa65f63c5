#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "apps/plane/discretize/drawing.h"
#include "apps/plane/document/document.h"
#include "apps/plane/document/part.h"

namespace plane {

/// What a place that is pointed at was drawn to, the strongest first.
enum class SnapKind : std::uint8_t {
    Point,    ///< of the document, or where drawing began
    Crossing, ///< of curves, or an end without a point
    Middle,   ///< of a piece of a curve, by its length; of a circle or an arc its centre
    OnCurve,  ///< the nearest place of a curve
    Grid,
    Free ///< nothing: the place is rounded, so that its numbers are short
};

/// A place in the plane of the drawing, in its unit of length, and what it was drawn to.
struct Snap {
    FlatPoint place;
    SnapKind kind = SnapKind::Free;
    std::optional<NodeId> point{}; ///< that is there

    friend bool operator==(const Snap&, const Snap&) = default;
};

struct SnapOptions {
    double reach = 0.1;             ///< how near the pointer must be to what it is drawn to [length]
    double grid = 1.0;              ///< distance of the grid's lines [length]; 0: there is none
    double fine = 0.1;              ///< to which places are rounded that nothing draws [length]; 0: to nothing
    std::vector<FlatPoint> draft{}; ///< places of the curve that is being drawn, which draw too
    std::optional<NodeId> moving{}; ///< is dragged: neither it nor its curves draw to themselves
    bool to_parts = true;           ///< else to the grid alone
    bool is_off = false;            ///< the place is where the pointer is
};

/// The place that is meant by the pointer's place. Of what lies within reach the strongest kind wins, of one kind the
/// nearest. \param drawing  null where there is none
Snap snap(const PlaneModel& model, const discretize::Drawing* drawing, const FlatPoint& pointer,
          const SnapOptions& options);

/// The part under a place: a point within reach, else a curve, else the face that it lies in.
std::optional<Part> part_under(const PlaneModel& model, const discretize::Drawing* drawing, const FlatPoint& at,
                               double reach);

} // namespace plane
