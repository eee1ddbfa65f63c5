#include "femoop/result/envelope.h"

#include <algorithm>
#include <stdexcept>

namespace femoop {

namespace {

std::vector<CaseId> all_cases(const Results& results)
{
    std::vector<CaseId> cases;
    for (std::size_t i = 0; i < results.n_cases(); ++i) cases.emplace_back(i);
    return cases;
}

struct StationPlace {
    double x = 0.0;
    Side side = Side::After;

    friend bool operator==(const StationPlace&, const StationPlace&) = default;
    friend bool operator<(const StationPlace& a, const StationPlace& b)
    {
        return a.x != b.x ? a.x < b.x : a.side == Side::Before && b.side == Side::After;
    }
};

std::vector<StationPlace> places(const std::vector<Curve>& curves, std::size_t n)
{
    std::vector<StationPlace> all;
    for (const Curve& curve : curves)
        for (const Station& station : curve.stations(n)) all.push_back({station.x, station.side});
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

} // namespace

Envelope::Envelope(Results results) : results_(std::move(results)), cases_(all_cases(results_)) {}

Envelope::Envelope(Results results, std::vector<CaseId> cases) : results_(std::move(results)), cases_(std::move(cases))
{
    if (cases_.empty()) throw std::invalid_argument("Envelope: no load case or combination to take the envelope of");
}

template <class Value> GoverningRange Envelope::range(const Value& value) const
{
    return governing_range(cases_, [&](std::size_t i) { return value(results_[cases_[i]]); });
}

GoverningRange Envelope::displacement(NodeId node, Dof dof) const
{
    return range([&](const CaseResult& result) { return result.displacement(node)[index(dof)]; });
}

GoverningRange Envelope::reaction(NodeId node, Dof dof) const
{
    return range([&](const CaseResult& result) { return result.reaction(node)[index(dof)]; });
}

GoverningExtremes Envelope::extremes(MemberId member, MemberComponent component) const
{
    GoverningExtremes governing;
    for (const CaseId id : cases_) {
        const Extremes own = results_[id].curve(member).extremes(component);
        const bool is_first = id == cases_.front();
        if (is_first || own.max.value > governing.max.value) governing.max = {own.max.value, id, own.max.x};
        if (is_first || own.min.value < governing.min.value) governing.min = {own.min.value, id, own.min.x};
    }
    return governing;
}

GoverningRange Envelope::at(MemberId member, MemberComponent component, double x, Side side) const
{
    return range([&](const CaseResult& result) { return result.curve(member).value(component, x, side); });
}

std::vector<EnvelopeStation> Envelope::stations(MemberId member, const std::vector<MemberComponent>& components,
                                                std::size_t n) const
{
    std::vector<Curve> curves;
    for (const CaseId id : cases_) curves.push_back(results_[id].curve(member));

    std::vector<EnvelopeStation> stations;
    for (const StationPlace& place : places(curves, n)) {
        EnvelopeStation station{place.x, place.side, std::vector<GoverningRange>(components.size())};
        for (std::size_t i = 0; i < components.size(); ++i)
            station.ranges[i] = governing_range(
                cases_, [&](std::size_t c) { return curves[c].value(components[i], place.x, place.side); });
        stations.push_back(std::move(station));
    }
    return stations;
}

} // namespace femoop
