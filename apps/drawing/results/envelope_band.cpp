#include "apps/drawing/results/envelope_band.h"

#include "apps/drawing/results/envelope_cases.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

using femoop::Curve;
using femoop::Dof;
using femoop::MemberComponent;
using femoop::Side;

template <class Value> void widen(Bound& least, Bound& most, std::size_t n, const Value& value)
{
    for (std::size_t i = 0; i < n; ++i) {
        const double one = value(i);
        if (i == 0 || one < least.value) least = {one, i};
        if (i == 0 || one > most.value) most = {one, i};
    }
}

/// Places along a member at which the band has its corners: the load points, the extremes and the points between.
std::vector<double> places(const std::vector<SolvedCase>& cases, femoop::MemberId member, MemberComponent component)
{
    constexpr int n_between = 40;
    const double length = cases.front()[member].length();
    std::vector<double> all;
    for (int i = 0; i <= n_between; ++i) all.push_back(length * i / n_between);
    for (const SolvedCase& solved : cases) {
        const Curve& curve = solved[member];
        for (const double x : curve.breaks()) all.push_back(x);
        const femoop::Extremes extremes = curve.extremes(component);
        all.insert(all.end(), {extremes.max.x, extremes.min.x});
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

/// Both sides of each place, so that jumps stand upright.
std::vector<BandSection> band_along(const std::vector<SolvedCase>& cases, femoop::MemberId member,
                                    MemberComponent component)
{
    std::vector<BandSection> sections;
    for (const double x : places(cases, member, component)) {
        for (const Side side : {Side::Before, Side::After}) {
            BandSection here{.x = x, .least = {}, .most = {}};
            widen(here.least, here.most, cases.size(),
                  [&](std::size_t i) { return cases[i][member].value(component, x, side); });
            const bool is_told = !sections.empty() && sections.back() == here;
            if (!is_told) sections.push_back(here);
        }
    }
    return sections;
}

} // namespace

double EnvelopeBands::largest() const
{
    double largest = 0.0;
    for (const std::vector<BandSection>& member : members)
        for (const BandSection& section : member)
            largest = std::max({largest, std::abs(section.least.value), std::abs(section.most.value)});
    return largest;
}

const EnvelopeBands* EnvelopePicture::find(MemberComponent component) const
{
    const auto found = std::ranges::find(bands, component, &EnvelopeBands::component);
    return found != bands.end() ? &*found : nullptr;
}

EnvelopeBands bands_of(const std::vector<SolvedCase>& cases, MemberComponent component)
{
    EnvelopeBands bands{.component = component, .members = {}};
    for (std::size_t i = 0; i < cases.front().curves.size(); ++i)
        bands.members.push_back(band_along(cases, femoop::MemberId(i), component));
    return bands;
}

std::vector<ReactionBand> reaction_bands_of(const std::vector<SolvedCase>& cases, std::size_t n_nodes)
{
    constexpr double noise = 1e-9; // of the largest force or moment
    femoop::Magnitudes largest;
    for (const SolvedCase& solved : cases) {
        const femoop::Magnitudes of_case = solved.result.magnitudes();
        largest.force = std::max(largest.force, of_case.force);
        largest.moment = std::max(largest.moment, of_case.moment);
    }
    std::vector<ReactionBand> bands;
    for (std::size_t i = 0; i < n_nodes; ++i) {
        const femoop::NodeId node{i};
        if (!cases.front().result.is_supported(node)) continue;
        for (const Dof dof : femoop::all_dofs) {
            const double least = noise * (femoop::is_rotation(dof) ? largest.moment : largest.force);
            ReactionBand band{.node = node, .dof = dof, .least = {}, .most = {}};
            widen(band.least, band.most, cases.size(), [&](std::size_t k) {
                const double value = cases[k].result.reaction(node)[femoop::index(dof)];
                return std::abs(value) > least ? value : 0.0;
            });
            bands.push_back(band);
        }
    }
    return bands;
}

std::vector<std::string> names_of(const std::vector<SolvedCase>& cases)
{
    std::vector<std::string> names;
    for (const SolvedCase& solved : cases) names.push_back(solved.result.name());
    return names;
}

std::string governed(const std::string& number, const Bound& bound, const std::vector<std::string>& names)
{
    return names.size() == 1 ? number : governed(number, names[bound.made_by]);
}

} // namespace drawing
