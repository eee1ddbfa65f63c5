#pragma once

#include <optional>
#include <vector>

#include "apps/plane/document/document.h"
#include "apps/plane/document/part.h"

namespace plane {

/// A place that a hand gives: where it is, and the point that is there already, if any.
struct DraftPlace {
    FlatPoint at;
    std::optional<NodeId> point{};

    friend bool operator==(const DraftPlace&, const DraftPlace&) = default;
};

/// A curve that is being drawn, by places of the plane.
struct CurveDraft {
    femoop::plane::DrawnKind kind = femoop::plane::DrawnKind::Line;
    std::vector<DraftPlace> places{};
    bool is_closed = false;             ///< of a line or a spline
    std::optional<DraftPlace> center{}; ///< of an arc, a circle or an ellipse
    double radius = 0.0;                ///< of a circle
    double a = 0.0, b = 0.0;            ///< half axes of an ellipse
    double angle = 0.0;                 ///< of a, in degrees
    bool is_clockwise = false;          ///< of an arc with a centre
};

/// The shape by coordinates alone, to be looked at before it is drawn.
femoop::plane::DrawnShape shape_of(const CurveDraft& draft);

/// Adds the curve, with points where there are none yet, so that all its places can be dragged.
CurveId draw_curve(Document& document, const CurveDraft& draft);

/// The point at this very place, made where there is none.
NodeId point_at(Document& document, const DraftPlace& place);
/// The same, as a further corner of the lines on whose sides it lies: where it is dragged later, they follow. Their
/// divisions, which are those of every piece, stay; of a list of one for each side, both halves get the side's.
NodeId corner_at(Document& document, const DraftPlace& place);

} // namespace plane
