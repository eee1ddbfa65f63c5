#include "apps/frame/session/picking.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "femoop/result/results.h"

namespace frame {

namespace {

// Where along a..b (0 to 1) the point is nearest.
double nearest_along(ui::Point a, ui::Point b, ui::Point p)
{
    const ui::Point d = b - a;
    const double square = dot(d, d);
    return square > 0.0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0.0;
}

} // namespace

Pick pick(const StructureShape& shape, const Projection& projection, ui::Point pointer, double reach)
{
    Pick found;
    double nearest = reach;
    for (std::size_t i = 0; i < shape.nodes.size(); ++i) {
        const double away = distance(projection(shape.nodes[i]), pointer);
        if (away > nearest) continue;
        nearest = away;
        found.node = femoop::NodeId(i);
    }
    if (found.node) return found;
    for (std::size_t i = 0; i < shape.members.size(); ++i) {
        const MemberShape& member = shape.members[i];
        const ui::Point a = projection(member.start);
        const ui::Point b = projection(member.end);
        const double along = nearest_along(a, b, pointer);
        const double away = distance(a + along * (b - a), pointer);
        if (away > nearest) continue;
        nearest = away;
        found.cut = Cut{femoop::MemberId(i), along * member.length};
    }
    return found;
}

namespace {

// 1, 2 or 5 times a power of ten, not below the value.
double round_above(double value)
{
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade >= value) return factor * decade;
    }
    return 10.0 * decade;
}

std::vector<double> worth_reading(const Session& session, const Cut& cut, double length)
{
    std::vector<double> places{0.0, 0.5 * length, length};
    const auto& results = session.solution().results;
    if (!results || results->n_cases() == 0) return places;
    const femoop::Curve curve = (*results)[session.view.load_case].curve(cut.member);
    for (const double load_point : curve.breaks()) places.push_back(load_point);
    const femoop::Extremes extremes = curve.extremes(femoop::MemberComponent::Mz);
    places.insert(places.end(), {extremes.max.x, extremes.min.x});
    return places;
}

} // namespace

Cut snapped(const Session& session, const StructureShape& shape, const Cut& cut, double pixels_per_length)
{
    constexpr double reach = 5.0;
    const double length = shape[cut.member].length;
    if (!(pixels_per_length > 0.0)) return cut;
    for (const double place : worth_reading(session, cut, length)) {
        if (std::abs(place - cut.x) * pixels_per_length <= reach) return {cut.member, place};
    }
    const double step = round_above(1.0 / pixels_per_length);
    return {cut.member, std::clamp(std::round(cut.x / step) * step, 0.0, length)};
}

ui::Point place_on_sheet(const StructureShape& shape, const Projection& projection, const Cut& cut)
{
    return projection(shape[cut.member].at(cut.x));
}

} // namespace frame
