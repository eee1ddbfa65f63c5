#include "apps/plane/document/points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "femoop/edit/short_number.h"
#include "topology/geometry/flat_point.h"

namespace plane {

using femoop::plane::DrawnKind;
using femoop::plane::DrawnPlace;
using femoop::plane::DrawnShape;

namespace {

/// As near to a line that a point lies on it.
double reach_of(const PlaneModel& model)
{
    if (model.snap) return *model.snap;
    topology::FlatBox box;
    for (const auto& point : model.points) box.add({point.at[0], point.at[1]});
    return box.is_empty() ? 0.0 : 1e-9 * box.diagonal();
}

/// Moves a point, and after it those that arcs tie to it and those that lie on straight sides of it.
class PointMove {
public:
    explicit PointMove(PlaneModel& model) : model_(model), is_moved_(model.points.size()), reach_(reach_of(model)) {}

    void move(NodeId point, const FlatPoint& to)
    {
        if (is_moved_[point.index]) return;
        is_moved_[point.index] = true;
        const std::vector<OnSide> along = points_on_sides(point);
        model_.points[point.index].at = {femoop::Quantity(to.x + 0.0), femoop::Quantity(to.y + 0.0)}; // + 0.0: no -0
        for (const auto& [side, share, on_it] : along) {
            const FlatPoint start = at(side[0]), end = at(side[1]);
            move(on_it, short_place(start + share * (end - start)));
        }
        for (auto& curve : model_.curves)
            if (curve.shape && curve.shape->kind == DrawnKind::Arc && curve.shape->center &&
                curve.shape->places.size() == 2)
                keep_arc(*curve.shape, point);
    }

private:
    /// A point within a straight side, which stays at its share of it.
    struct OnSide {
        std::array<DrawnPlace, 2> side;
        double share;
        NodeId point;
    };

    std::vector<OnSide> points_on_sides(NodeId of) const
    {
        std::vector<OnSide> found;
        for (const auto& curve : model_.curves) {
            if (!curve.shape || curve.shape->kind != DrawnKind::Line) continue;
            const std::vector<DrawnPlace>& places = curve.shape->places;
            if (places.size() < 2) continue;
            const std::size_t n = places.size(), n_sides = curve.shape->is_closed ? n : n - 1;
            for (std::size_t i = 0; i < n_sides; ++i) {
                const DrawnPlace &start = places[i], &end = places[(i + 1) % n];
                if (start.point == of || end.point == of) add_points_on(start, end, found);
            }
        }
        return found;
    }

    void add_points_on(const DrawnPlace& start, const DrawnPlace& end, std::vector<OnSide>& found) const
    {
        const FlatPoint a = at(start);
        const topology::FlatVector side = at(end) - a;
        const double squared = topology::dot(side, side);
        if (!(squared > 0.0)) return;
        for (std::size_t i = 0; i < model_.points.size(); ++i) {
            const NodeId point(i);
            if (is_moved_[i] || start.point == point || end.point == point) continue;
            const topology::FlatVector arm = place_of(model_, point) - a;
            const double share = topology::dot(arm, side) / squared;
            const bool is_beside = std::abs(topology::cross(side, arm)) > reach_ * std::sqrt(squared);
            if (share > 0.0 && share < 1.0 && !is_beside) found.push_back({{start, end}, share, point});
        }
    }

    FlatPoint at(const DrawnPlace& place) const
    {
        return place.point ? place_of(model_, *place.point) : FlatPoint{place.at[0], place.at[1]};
    }

    void set(DrawnPlace& place, const FlatPoint& to)
    {
        if (place.point) return move(*place.point, to);
        place.at = {femoop::Quantity(to.x), femoop::Quantity(to.y)};
    }

    void keep_arc(DrawnShape& arc, NodeId moved)
    {
        if (arc.center->point == moved) return keep_center(arc);
        for (const std::size_t i : {0U, 1U})
            if (arc.places[i].point == moved && arc.places[1 - i].point != moved)
                return take_radius(arc.places[1 - i], at(*arc.center),
                                   topology::distance(at(arc.places[i]), at(*arc.center)));
    }

    void take_radius(DrawnPlace& end, const FlatPoint& center, double radius)
    {
        const topology::FlatVector arm = at(end) - center;
        const double length = topology::length(arm);
        if (length > 0.0) set(end, center + (radius / length) * arm);
    }

    /// Onto the line that is as far from one end as from the other.
    void keep_center(DrawnShape& arc)
    {
        const FlatPoint start = at(arc.places[0]), end = at(arc.places[1]), center = at(*arc.center);
        const topology::FlatVector chord = end - start;
        const double squared = topology::dot(chord, chord);
        if (!(squared > 0.0)) return;
        const topology::FlatVector from_middle = center - topology::middle(start, end);
        const FlatPoint kept = center + (-topology::dot(from_middle, chord) / squared) * chord;
        model_.points[arc.center->point->index].at = {femoop::Quantity(kept.x), femoop::Quantity(kept.y)};
    }

    PlaneModel& model_;
    std::vector<bool> is_moved_;
    double reach_;
};

} // namespace

FlatPoint short_place(const FlatPoint& place)
{
    const double size = std::max(std::abs(place.x), std::abs(place.y));
    return {femoop::short_number(place.x, size), femoop::short_number(place.y, size)};
}

FlatPoint place_of(const PlaneModel& model, NodeId point) { return {model[point].at[0], model[point].at[1]}; }

void move_point(Document& document, NodeId point, const FlatPoint& to) { PointMove(document.model).move(point, to); }

} // namespace plane
