#include "apps/plane/view/probe_values.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "femoop/plane/analysis/stress_state_values.h"

namespace plane {

namespace {

namespace fp = femoop::plane;

/// The elements of one region that hold a place.
std::vector<fp::Location> of_first_region(const fp::PlaneModel& mesh, const std::vector<fp::Location>& places)
{
    std::vector<fp::Location> same;
    for (const fp::Location& place : places)
        if (mesh[place.element].region == mesh[places.front().element].region) same.push_back(place);
    return same;
}

/// Of the first principal direction [degrees], without what is rounding alone.
double first_angle(const fp::PlaneStress& stress)
{
    const double angle = fp::principal(stress).angle * 180.0 / std::numbers::pi;
    return std::abs(angle) < 1e-8 ? 0.0 : angle;
}

double size_of(const fp::PlaneStress& stress)
{
    const fp::PrincipalStress principal = fp::principal(stress);
    return std::max({std::abs(principal.s1), std::abs(principal.s2), std::abs(stress.sz)});
}

/// Reads one component of the stresses of a place.
class StressReader {
public:
    StressReader(const fp::PlaneCase& result, const fp::PlaneModel& mesh, const std::vector<fp::Location>& places)
        : smoothed_(result.smoothed_stress(places.front())),
          mean_(result.element_stress(places, mesh[places.front().element].region)),
          size_(size_of(smoothed_))
    {
        for (const fp::Location& place : places) of_elements_.push_back(result.element_stress(place));
    }

    fp::PlaneStress smoothed() const
    {
        return {.sx = rounded(smoothed_.sx),
                .sy = rounded(smoothed_.sy),
                .sz = rounded(smoothed_.sz),
                .txy = rounded(smoothed_.txy)};
    }

    ProbeValue stress(const char* symbol, const std::function<double(const fp::PlaneStress&)>& read) const
    {
        ProbeValue value{.symbol = symbol, .smoothed = rounded(read(smoothed_)), .element = rounded(read(mean_))};
        if (of_elements_.size() < 2) return value;
        const auto [least, most] = std::ranges::minmax(of_elements_, {}, read);
        value.jump = rounded(read(most) - read(least));
        return value;
    }
    ProbeValue angle() const
    {
        return {.symbol = "θ1",
                .measure = ui::Measure::Angle,
                .smoothed = first_angle(smoothed_),
                .element = first_angle(mean_)};
    }

private:
    double rounded(double value) const { return std::abs(value) < 1e-9 * size_ ? 0.0 : value; }

    fp::PlaneStress smoothed_, mean_;
    std::vector<fp::PlaneStress> of_elements_;
    double size_;
};

} // namespace

std::optional<ProbeState> probe_state(const fp::PlaneResults& results, const fp::PlaneCase& result,
                                      const Eigen::Vector2d& at)
{
    const auto found = results.locator().find(at);
    if (found.empty()) return std::nullopt;
    const auto places = of_first_region(results.model(), found);
    const StressReader reader(result, results.model(), places);
    const Eigen::Vector2d u = result.displacement(places.front());
    const fp::PlaneModel& mesh = results.model();
    const auto region_of = [&](const fp::Location& place) { return mesh[mesh[place.element].region].id; };
    ProbeState state{
        .values = {}, .smoothed = reader.smoothed(), .n_elements = places.size(), .region = region_of(places.front())};
    for (const fp::Location& place : found) {
        const std::string region = region_of(place);
        const bool is_known = region == state.region ||
                              std::ranges::find(state.beyond, region, &ProbeState::Beyond::region) !=
                                  state.beyond.end();
        if (!is_known) state.beyond.push_back({region, result.smoothed_stress(place)});
    }
    auto& values = state.values;
    values.push_back({.symbol = "ux", .measure = ui::Measure::Displacement, .smoothed = u.x()});
    values.push_back({.symbol = "uy", .measure = ui::Measure::Displacement, .smoothed = u.y()});
    values.push_back(reader.stress("σx", [](const fp::PlaneStress& s) { return s.sx; }));
    values.push_back(reader.stress("σy", [](const fp::PlaneStress& s) { return s.sy; }));
    if (results.model().analysis != femoop::StressState::PlaneStress)
        values.push_back(reader.stress("σz", [](const fp::PlaneStress& s) { return s.sz; }));
    values.push_back(reader.stress("τxy", [](const fp::PlaneStress& s) { return s.txy; }));
    values.push_back(reader.stress("σ1", [](const fp::PlaneStress& s) { return fp::principal(s).s1; }));
    values.push_back(reader.stress("σ2", [](const fp::PlaneStress& s) { return fp::principal(s).s2; }));
    values.push_back(reader.angle());
    values.push_back(reader.stress("σ Mises", [](const fp::PlaneStress& s) { return fp::von_mises(s); }));
    return state;
}

mohr::StressPoint stress_point(const ProbeState& state, const ui::DisplayUnits& units)
{
    const ui::DisplayUnit unit = units.unit(ui::Measure::Stress);
    const fp::PlaneStress& s = state.smoothed;
    return {.state = {.x = unit.factor * s.sx, .y = unit.factor * s.sy, .xy = unit.factor * s.txy},
            .third = unit.factor * s.sz,
            .unit = unit.name};
}

std::string text_of(const ProbeState::Beyond& beyond, const ui::DisplayUnits& units)
{
    const fp::PlaneStress& s = beyond.smoothed;
    const auto stress = [&](double value) { return number_of(value, ui::Measure::Stress, units); };
    return beyond.region + ": σx " + stress(s.sx) + ", σy " + stress(s.sy) + ", τxy " + stress(s.txy) + ", σ Mises " +
           stress(fp::von_mises(s));
}

std::string number_of(double value, ui::Measure measure, const ui::DisplayUnits& units)
{
    return ui::with_minus_signs(units.number(value, measure));
}

} // namespace plane
