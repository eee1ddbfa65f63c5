// What is wrong with a drawing before it is looked at as one: numbers, and how many places draw a curve.
#include "femoop/plane/check/plane_checker.h"

#include "femoop/model/quantity/number_text.h"

namespace femoop::plane {

namespace {

constexpr double most_ratio = 1e6; // of the last part of a curve to the first

/// How many places a kind of curve wants, for its reader; empty where it has as many.
std::string_view places_wanted(const DrawnShape& shape)
{
    const std::size_t n = shape.places.size();
    switch (shape.kind) {
    case DrawnKind::Line: return n >= 2 ? "" : translatable("2 or more of a line");
    case DrawnKind::Spline: return n >= 3 ? "" : translatable("3 or more of a spline");
    case DrawnKind::Bezier: return n >= 4 && n % 3 == 1 ? "" : translatable("4, 7, 10 or so on of a Bézier curve");
    case DrawnKind::Circle: return "";
    case DrawnKind::Ellipse:
        return n == 0 || n == 2 ? "" : translatable("its start and its end, or none, of an ellipse");
    case DrawnKind::Arc: break;
    }
    if (shape.center) return n == 2 ? "" : translatable("its start and its end, of an arc with a centre");
    return n == 3 ? "" : translatable("its start, a place on it and its end, of an arc without a centre");
}

} // namespace

void PlaneChecker::check_drawn_curves()
{
    for (std::size_t i = 0; i < model_.curves.size(); ++i) {
        const PlaneCurve& curve = model_.curves[i];
        const Entry place{"curves", i, curve.id};
        is_partial_ = flag(unreadable_.curves, i);
        if (curve.shape) check_shape(*curve.shape, place);
        if (curve.support) check_support(*curve.support, true, place);
        check_tied(curve, place);
    }
}

void PlaneChecker::check_shape(const DrawnShape& shape, const Entry& place)
{
    check_places(shape, place);
    if (shape.radius) require_positive(place, "radius", *shape.radius, dimension::length);
    for (const Quantity& axis : shape.axes) require_positive(place, "axes", axis, dimension::length);
    if (shape.angle) require_finite(place, "angle", *shape.angle);
    for (const Division& division : shape.divide)
        if (division.ratio) {
            require_positive(place, "ratio", *division.ratio, dimension::none);
            const double ratio = division.ratio->value();
            if (ratio > most_ratio || (ratio > 0.0 && ratio < 1.0 / most_ratio))
                add(FaultKind::WrongType, place,
                    {number_text(ratio), std::string(translatable("a ratio of parts from 0.000001 to 1000000")),
                     R"({"n": 8, "ratio": 2})"});
        }
    if (is_partial_) return;
    if (const std::string_view wanted = places_wanted(shape); !wanted.empty())
        add(FaultKind::DrawnPlaceCount, place, {std::to_string(shape.places.size()), std::string(wanted)});
}

void PlaneChecker::check_places(const DrawnShape& shape, const Entry& place)
{
    for (const DrawnPlace& each : shape.places) check_place(each, place);
    if (shape.center) check_place(*shape.center, place);
}

void PlaneChecker::check_place(const DrawnPlace& drawn, const Entry& place)
{
    if (drawn.point) {
        require_entry(place, "points", drawn.point->index, model_.points.size());
        return;
    }
    require_within_reach(place, "x", drawn.at[0]);
    require_within_reach(place, "y", drawn.at[1]);
    if (model_.analysis == StressState::Axisymmetric && drawn.at[0] < 0.0)
        add(FaultKind::PointLeftOfAxis, place, {shown(drawn.at[0], dimension::length)});
}

/// Their places, and that one of them at most takes all the rest.
void PlaneChecker::check_drawn_regions()
{
    std::optional<std::size_t> rest;
    for (std::size_t i = 0; i < model_.regions.size(); ++i) {
        const PlaneRegion& region = model_.regions[i];
        const Entry place{"regions", i, region.id};
        is_partial_ = flag(unreadable_.regions, i);
        for (const auto& [x, y] : region.at) {
            require_within_reach(place, "x", x);
            require_within_reach(place, "y", y);
        }
        if (!region.at.empty() || is_partial_) continue;
        if (rest) add(FaultKind::SecondRestOfFaces, place, {Entry{"regions", *rest, model_.regions[*rest].id}.text()});
        else rest = i;
    }
}

void PlaneChecker::check_face_asked(const PlaneExpected& check, const Entry& place)
{
    const bool is_of_face = check.point || !check.at.empty() || check.region || check.rank;
    const bool needs_face = check.quantity == PlaneQuantity::Area || check.counted == "holes";
    if (needs_face && !is_of_face) add(FaultKind::CheckFacePlace, place, {std::string(name(check.quantity))});
}

} // namespace femoop::plane
