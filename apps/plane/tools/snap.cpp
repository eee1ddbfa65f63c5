#include "apps/plane/tools/snap.h"

#include <algorithm>
#include <cmath>

#include "apps/plane/document/points.h"
#include "femoop/edit/short_number.h"

namespace plane {

using discretize::Drawing;
using topology::Curve;
using topology::EdgeId;
using topology::Span;

namespace {

/// Collects candidates and keeps the best.
class Magnet {
public:
    Magnet(const FlatPoint& pointer, double reach) : pointer_(pointer), reach_(reach) {}

    void offer(const FlatPoint& place, SnapKind kind, std::optional<NodeId> point = std::nullopt)
    {
        const double distance = topology::distance(place, pointer_);
        if (distance > reach_) return;
        if (best_ && (best_->kind < kind || (best_->kind == kind && distance_ <= distance))) return;
        best_ = Snap{place, kind, point};
        distance_ = distance;
    }
    const std::optional<Snap>& best() const { return best_; }

private:
    FlatPoint pointer_;
    double reach_;
    std::optional<Snap> best_;
    double distance_ = 0.0;
};

/// Never -0, which a file would keep.
double rounded(double x, double step)
{
    return step > 0.0 ? femoop::short_number(step * std::round(x / step), x) : x + 0.0;
}
FlatPoint rounded(const FlatPoint& p, double step) { return {rounded(p.x, step), rounded(p.y, step)}; }

bool is_drawn_by(const PlaneModel& model, CurveId curve, NodeId point)
{
    const auto& shape = model[curve].shape;
    if (!shape) return false;
    const auto is_it = [point](const femoop::plane::DrawnPlace& place) { return place.point == point; };
    return std::ranges::any_of(shape->places, is_it) || (shape->center && is_it(*shape->center));
}

bool moves(const Drawing& drawing, EdgeId edge, const std::optional<NodeId>& moving)
{
    return moving && std::ranges::any_of(drawing.subdivision().carriers(edge), [&](const topology::CurvePart& part) {
               return is_drawn_by(drawing.model(), drawing.owner(part.curve), *moving);
           });
}

/// The parameter at half the length.
double middle_of(const Curve& curve, Span span)
{
    if (!curve.cubic()) return span.middle();
    const double half = 0.5 * curve.length(span);
    double low = span.from, high = span.to;
    for (int i = 0; i < 50; ++i) {
        const double t = 0.5 * (low + high);
        (curve.length({span.from, t}) < half ? low : high) = t;
    }
    return 0.5 * (low + high);
}

/// Whether an edge comes as near as the reach.
bool is_near(const Curve& curve, Span span, const FlatPoint& at, double reach)
{
    return curve.box(span).grown(reach).has(at);
}

class CurveOffers {
public:
    CurveOffers(const Drawing& drawing, const FlatPoint& pointer, const SnapOptions& options, Magnet& magnet)
        : drawing_(drawing), pointer_(pointer), options_(options), magnet_(magnet)
    {}

    void make()
    {
        const auto& plane = drawing_.subdivision();
        if (plane.solid().is_empty()) return;
        for (const EdgeId edge : plane.solid().edges()) {
            if (moves(drawing_, edge, options_.moving)) continue;
            const topology::CurvePart& part = plane.part(edge);
            const Curve& curve = plane.curve(part.curve);
            if (const auto* const arc = curve.arc()) magnet_.offer(arc->center, SnapKind::Middle);
            if (!is_near(curve, part.span, pointer_, options_.reach)) continue;
            offer_edge(edge, curve, part.span);
        }
    }

private:
    void offer_edge(EdgeId edge, const Curve& curve, Span span)
    {
        const auto& plane = drawing_.subdivision();
        const auto moving = options_.moving ? drawing_.vertex(*options_.moving) : std::nullopt;
        bool ends_at_moving = false; // its end and its middle go with the hand
        for (const topology::HalfEdgeId h : {plane.solid().plus(edge), plane.solid().minus(edge)}) {
            const topology::VertexId end = plane.solid().start(h);
            if (end == moving) ends_at_moving = true;
            else magnet_.offer(plane.at(end), SnapKind::Crossing);
        }
        if (!ends_at_moving) magnet_.offer(curve.at(middle_of(curve, span)), SnapKind::Middle);
        magnet_.offer(place_on(curve, curve.nearest(pointer_, span)), SnapKind::OnCurve);
    }

    /// On a straight line at a round distance from its start.
    FlatPoint place_on(const Curve& curve, double t) const
    {
        const topology::Segment* const line = curve.segment();
        if (line == nullptr || !(options_.fine > 0.0)) return curve.at(t);
        const topology::FlatVector arm = line->b - line->a;
        const double length = topology::length(arm), along = rounded(t * length, options_.fine);
        return along > 0.0 && along < length ? short_place(line->a + (along / length) * arm) : curve.at(t);
    }

    const Drawing& drawing_;
    const FlatPoint& pointer_;
    const SnapOptions& options_;
    Magnet& magnet_;
};

std::optional<CurveId> curve_under(const Drawing& drawing, const FlatPoint& at, double reach)
{
    const auto& plane = drawing.subdivision();
    std::optional<CurveId> nearest;
    if (plane.solid().is_empty()) return nearest;
    double least = reach;
    for (const EdgeId edge : plane.solid().edges()) {
        const topology::CurvePart& part = plane.part(edge);
        const Curve& curve = plane.curve(part.curve);
        if (!is_near(curve, part.span, at, reach)) continue;
        const double distance = topology::distance(curve.at(curve.nearest(at, part.span)), at);
        if (distance > least) continue;
        least = distance;
        nearest = drawing.owner(part.curve);
    }
    return nearest;
}

} // namespace

Snap snap(const PlaneModel& model, const Drawing* drawing, const FlatPoint& pointer, const SnapOptions& options)
{
    if (options.is_off) return {pointer, SnapKind::Free};
    Magnet magnet(pointer, options.reach);
    for (std::size_t i = 0; i < model.points.size() && options.to_parts; ++i)
        if (options.moving != NodeId(i)) magnet.offer(place_of(model, NodeId(i)), SnapKind::Point, NodeId(i));
    for (const FlatPoint& place : options.draft) magnet.offer(place, SnapKind::Point);
    if (drawing != nullptr && options.to_parts) CurveOffers(*drawing, pointer, options, magnet).make();
    if (options.grid > 0.0) magnet.offer(rounded(pointer, options.grid), SnapKind::Grid);
    return magnet.best().value_or(Snap{rounded(pointer, options.fine), SnapKind::Free});
}

std::optional<Part> part_under(const PlaneModel& model, const Drawing* drawing, const FlatPoint& at, double reach)
{
    std::optional<Part> nearest;
    double least = reach;
    for (std::size_t i = 0; i < model.points.size(); ++i)
        if (const double distance = topology::distance(place_of(model, NodeId(i)), at); distance <= least) {
            least = distance;
            nearest = NodeId(i);
        }
    if (nearest || drawing == nullptr) return nearest;
    if (const auto curve = curve_under(*drawing, at, reach)) return *curve;
    if (drawing->face_at(at)) return FacePlace{at};
    return std::nullopt;
}

} // namespace plane
