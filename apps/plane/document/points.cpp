#include "apps/plane/document/points.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "femoop/edit/short_number.h"

namespace plane {

using femoop::plane::DrawnKind;
using femoop::plane::DrawnPlace;
using femoop::plane::DrawnShape;

namespace {

/// Moves a point, and after it those that arcs tie to it.
class PointMove {
public:
    explicit PointMove(PlaneModel& model) : model_(model), is_moved_(model.points.size()) {}

    void move(NodeId point, const FlatPoint& to)
    {
        if (is_moved_[point.index]) return;
        is_moved_[point.index] = true;
        model_.points[point.index].at = {femoop::Quantity(to.x + 0.0), femoop::Quantity(to.y + 0.0)}; // + 0.0: no -0
        for (auto& curve : model_.curves)
            if (curve.shape && curve.shape->kind == DrawnKind::Arc && curve.shape->center &&
                curve.shape->places.size() == 2)
                keep_arc(*curve.shape, point);
    }

private:
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
