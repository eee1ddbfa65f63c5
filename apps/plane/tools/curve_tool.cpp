#include "apps/plane/tools/curve_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "femoop/edit/short_number.h"

namespace plane {

using femoop::plane::DrawnKind;
using topology::distance;

namespace {

bool is_same(const DraftPlace& a, const DraftPlace& b) { return (a.point && a.point == b.point) || a.at == b.at; }

/// The place on the circle through `start` that lies towards `end`.
std::optional<DraftPlace> on_circle(const FlatPoint& center, const FlatPoint& start, const DraftPlace& end)
{
    constexpr double as_good_as = 1e-9; // of the radius
    const double radius = distance(center, start), reach = distance(center, end.at);
    if (!(radius > 0.0) || !(reach > 0.0)) return std::nullopt;
    if (std::abs(reach - radius) <= as_good_as * radius) return end;
    return DraftPlace{center + (radius / reach) * (end.at - center)};
}

std::optional<CurveDraft> arc_about_center(const std::vector<DraftPlace>& places, bool takes_long_way)
{
    const DraftPlace &center = places[0], &start = places[1];
    const auto end = on_circle(center.at, start.at, places[2]);
    if (!end || is_same(start, *end)) return std::nullopt;
    const bool is_left = topology::cross(start.at - center.at, end->at - center.at) >= 0.0;
    return CurveDraft{
        .kind = DrawnKind::Arc, .places = {start, *end}, .center = center, .is_clockwise = is_left == takes_long_way};
}

/// The largest coordinate, by which lengths between the places are rounded.
double size_of(const std::vector<DraftPlace>& places)
{
    double largest = 0.0;
    for (const DraftPlace& place : places) largest = std::max({largest, std::abs(place.at.x), std::abs(place.at.y)});
    return largest;
}

std::optional<CurveDraft> ellipse(const std::vector<DraftPlace>& places)
{
    const topology::FlatVector a = places[1].at - places[0].at;
    const double length = topology::length(a);
    const double b = length > 0.0 ? std::abs(topology::cross(a, places[2].at - places[0].at)) / length : 0.0;
    if (!(b > 0.0)) return std::nullopt;
    const double reach = size_of(places);
    return CurveDraft{.kind = DrawnKind::Ellipse,
                      .center = places[0],
                      .a = femoop::short_number(length, reach),
                      .b = femoop::short_number(b, reach),
                      .angle = femoop::short_number(std::atan2(a.y, a.x) * 180.0 / std::numbers::pi, 180.0)};
}

} // namespace

std::size_t CurveTool::n_places() const
{
    switch (kind_) {
    case CurveToolKind::Line:
    case CurveToolKind::Circle: return 2;
    case CurveToolKind::Arc:
    case CurveToolKind::ArcCenter:
    case CurveToolKind::Ellipse: return 3;
    case CurveToolKind::Bezier: return 4;
    case CurveToolKind::Polyline:
    case CurveToolKind::Spline: break;
    }
    return 0;
}

std::optional<CurveDraft> CurveTool::whole(const std::vector<DraftPlace>& places, bool takes_long_way) const
{
    switch (kind_) {
    case CurveToolKind::Line:
    case CurveToolKind::Polyline: return CurveDraft{.kind = DrawnKind::Line, .places = places};
    case CurveToolKind::Arc: return CurveDraft{.kind = DrawnKind::Arc, .places = places};
    case CurveToolKind::ArcCenter: return arc_about_center(places, takes_long_way);
    case CurveToolKind::Circle:
        return CurveDraft{.kind = DrawnKind::Circle,
                          .center = places[0],
                          .radius = femoop::short_number(distance(places[0].at, places[1].at), size_of(places))};
    case CurveToolKind::Ellipse: return ellipse(places);
    case CurveToolKind::Bezier: return CurveDraft{.kind = DrawnKind::Bezier, .places = places};
    case CurveToolKind::Spline: return CurveDraft{.kind = DrawnKind::Spline, .places = places};
    }
    return std::nullopt;
}

std::optional<CurveDraft> CurveTool::add(const DraftPlace& place, bool takes_long_way)
{
    if (has_begun() && is_same(places_.back(), place)) { // the second click at one place
        if (kind_ == CurveToolKind::Line) escape();
        return grows() ? finish() : std::nullopt;
    }
    const bool closes = grows() && places_.size() >= 3 && is_same(places_.front(), place);
    if (closes) {
        std::optional<CurveDraft> closed = finish();
        closed->is_closed = true;
        return closed;
    }
    places_.push_back(place);
    if (!has_begun() || places_.size() != n_places()) return std::nullopt;
    std::optional<CurveDraft> drawn = whole(places_, takes_long_way);
    if (!drawn) {
        places_.pop_back();
        return std::nullopt;
    }
    places_.clear();
    if (kind_ != CurveToolKind::Line) return drawn;
    if (!first_) first_ = drawn->places.front();
    if (is_same(*first_, place)) first_.reset(); // the outline is closed
    else places_.push_back(place);
    return drawn;
}

std::optional<CurveDraft> CurveTool::finish()
{
    if (kind_ == CurveToolKind::Line) {
        escape();
        return std::nullopt;
    }
    if (!grows() || places_.size() < fewest()) return std::nullopt;
    return whole(std::exchange(places_, {}), false);
}

bool CurveTool::lacks_places() const
{
    if (!has_begun() || kind_ == CurveToolKind::Line) return false; // lines end where the last one did
    return !grows() || places_.size() < fewest();
}

bool CurveTool::escape()
{
    const bool had_begun = has_begun();
    if (kind_ == CurveToolKind::Line) places_.clear();
    else if (had_begun) places_.pop_back();
    first_.reset();
    return had_begun;
}

std::optional<FlatPoint> CurveTool::from() const
{
    if (places_.empty()) return std::nullopt;
    const bool counts_from_center = kind_ == CurveToolKind::ArcCenter || kind_ == CurveToolKind::Ellipse;
    return counts_from_center ? places_.front().at : places_.back().at;
}

std::optional<CurveDraft> CurveTool::preview(const FlatPoint& pointer, bool takes_long_way) const
{
    if (places_.empty() || places_.back().at == pointer) return std::nullopt;
    std::vector<DraftPlace> places = places_;
    places.push_back({pointer});
    return seen(std::move(places), takes_long_way);
}

std::optional<CurveDraft> CurveTool::begun() const { return places_.empty() ? std::nullopt : seen(places_, false); }

std::optional<CurveDraft> CurveTool::seen(std::vector<DraftPlace> places, bool takes_long_way) const
{
    const bool is_spline_to_be = kind_ == CurveToolKind::Spline && places.size() >= 3;
    const bool is_whole = grows() ? is_spline_to_be : places.size() == n_places();
    if (is_whole)
        if (auto drawn = whole(places, takes_long_way)) return drawn;
    return CurveDraft{.kind = DrawnKind::Line, .places = std::move(places)};
}

} // namespace plane
