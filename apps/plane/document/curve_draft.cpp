#include "apps/plane/document/curve_draft.h"

#include <algorithm>
#include <cmath>

#include "apps/plane/document/fresh_id.h"
#include "apps/plane/document/points.h"

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

namespace {

/// On the straight side between two places, and at neither.
bool is_inside_side(const FlatPoint& at, const FlatPoint& a, const FlatPoint& b)
{
    constexpr double near = 1e-9; // of its length
    const topology::FlatVector side = b - a, arm = at - a;
    const double squared = topology::dot(side, side);
    if (!(squared > 0.0)) return false;
    const double t = topology::dot(arm, side) / squared;
    return std::abs(topology::cross(side, arm)) <= near * squared && t > near && t < 1.0 - near;
}

FlatPoint place_in(const PlaneModel& model, const DrawnPlace& place)
{
    return place.point ? place_of(model, *place.point) : FlatPoint{place.at[0], place.at[1]};
}

void add_corner(const PlaneModel& model, DrawnShape& line, NodeId corner)
{
    const auto has_corner = [&](const DrawnPlace& place) { return place.point == corner; };
    if (line.kind != DrawnKind::Line || std::ranges::any_of(line.places, has_corner)) return;
    const std::size_t n = line.places.size(), n_sides = line.is_closed ? n : n - 1;
    for (std::size_t i = 0; i < n_sides; ++i) {
        const FlatPoint a = place_in(model, line.places[i]), b = place_in(model, line.places[(i + 1) % n]);
        if (!is_inside_side(place_of(model, corner), a, b)) continue;
        const auto behind = static_cast<std::ptrdiff_t>(i) + 1;
        line.places.insert(line.places.begin() + behind, DrawnPlace{corner, {}});
        if (line.is_divided_by_piece && line.divide.size() == n_sides) {
            const femoop::plane::Division both = line.divide[i];
            line.divide.insert(line.divide.begin() + behind, both);
        }
        return;
    }
}

} // namespace

NodeId corner_at(Document& document, const DraftPlace& place)
{
    const NodeId corner = point_at(document, place);
    for (auto& curve : document.model.curves)
        if (curve.shape) add_corner(document.model, *curve.shape, corner);
    return corner;
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
