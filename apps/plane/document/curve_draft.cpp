#include "apps/plane/document/curve_draft.h"

#include <algorithm>

#include "apps/plane/document/fresh_id.h"

namespace plane {

using femoop::Quantity;
using femoop::plane::DrawnKind;
using femoop::plane::DrawnPlace;
using femoop::plane::DrawnShape;

namespace {

template <class PlaceOf> DrawnShape shape_by(const CurveDraft& draft, const PlaceOf& place_of)
{
    DrawnShape shape{.kind = draft.kind, .is_closed = draft.is_closed};
    for (const DraftPlace& place : draft.places) shape.places.push_back(place_of(place));
    if (draft.center) shape.center = place_of(*draft.center);
    if (draft.kind == DrawnKind::Circle) shape.radius = draft.radius;
    if (draft.kind == DrawnKind::Ellipse) {
        shape.axes = {Quantity(draft.a), Quantity(draft.b)};
        if (draft.angle != 0.0) shape.angle = draft.angle;
    }
    if (draft.is_clockwise) shape.is_clockwise = true;
    return shape;
}

} // namespace

DrawnShape shape_of(const CurveDraft& draft)
{
    return shape_by(draft, [](const DraftPlace& place) {
        return DrawnPlace{std::nullopt, {Quantity(place.at.x), Quantity(place.at.y)}};
    });
}

NodeId point_at(Document& document, const DraftPlace& place)
{
    if (place.point) return *place.point;
    auto& points = document.model.points;
    const auto same = std::ranges::find_if(points, [&](const auto& point) {
        return FlatPoint{point.at[0], point.at[1]} == place.at;
    });
    if (same != points.end()) return NodeId(static_cast<std::size_t>(same - points.begin()));
    points.push_back({.id = fresh_point_id(document.model),
                      .at = {Quantity(place.at.x), Quantity(place.at.y)},
                      .support = {},
                      .size = {}});
    return NodeId(points.size() - 1);
}

CurveId draw_curve(Document& document, const CurveDraft& draft)
{
    DrawnShape shape = shape_by(draft, [&](const DraftPlace& place) {
        return DrawnPlace{point_at(document, place), {}};
    });
    auto& curves = document.model.curves;
    curves.push_back({.id = fresh_id(curves, "C1"), .points = {}, .shape = std::move(shape), .support = {}, .tie = {}});
    return CurveId(curves.size() - 1);
}

} // namespace plane
