#include "apps/frame/session/snapping.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "apps/frame/tools/snap.h"
#include "femoop/result/results.h"

namespace frame {

namespace {

std::vector<double> worth_reading(const Session& session, const Cut& cut, double length)
{
    std::vector<double> places{0.0, 0.5 * length, length};
    const femoop::Results* const results = session.shown_results();
    if (results == nullptr || results->n_cases() == 0) return places;
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
    const double step = round_grid(1.0 / pixels_per_length);
    return {cut.member, std::clamp(std::round(cut.x / step) * step, 0.0, length)};
}

} // namespace frame
