#include "femoop/plane/analysis/result_reader.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace femoop::plane {

namespace {

Eigen::Vector2d place_or_origin(const std::vector<Quantity>& at)
{
    return at.empty() ? Eigen::Vector2d(0.0, 0.0) : Eigen::Vector2d(at[0], at[1]);
}

Eigen::Vector2d place_of(const PlaneModel& model, const PlaneExpected& check)
{
    return check.point ? position(model[*check.point]) : Eigen::Vector2d(check.at[0], check.at[1]);
}

std::vector<NodeId> all_nodes(const PlaneModel& model)
{
    std::vector<NodeId> nodes;
    for (std::size_t i = 0; i < model.points.size(); ++i) nodes.emplace_back(i);
    return nodes;
}

std::vector<NodeId> nodes_of_curve(const PlaneStructure& structure, CurveId curve)
{
    return nodes_along(structure.curves().edges[curve.index]);
}

/// In the region that the check names, or the one that there is.
RegionId region_of(const PlaneModel& model, const PlaneExpected& check, const std::vector<Location>& places)
{
    return check.region ? *check.region : model[places.front().element].region;
}

Location in_region(const PlaneModel& model, const std::vector<Location>& places, RegionId region)
{
    for (const Location& place : places)
        if (model[place.element].region == region) return place;
    return places.front();
}

double stress_value(const PlaneResults& results, const PlaneCase& result, const PlaneExpected& check)
{
    const std::vector<Location> places = locations_of(results, check);
    const RegionId region = region_of(results.model(), check, places);
    const PlaneStress stress = check.read == StressReading::Element
                                   ? result.element_stress(places, region)
                                   : result.smoothed_stress(in_region(results.model(), places, region));
    return component(stress, *check.component, place_of(results.model(), check), place_or_origin(check.about));
}

double strain_value(const PlaneResults& results, const PlaneCase& result, const PlaneExpected& check)
{
    const std::vector<Location> places = locations_of(results, check);
    const RegionId region = region_of(results.model(), check, places);
    return component(result.smoothed_strain(in_region(results.model(), places, region)), *check.component);
}

double reaction_value(const PlaneCase& result, const PlaneExpected& check)
{
    const PlaneStructure& structure = result.structure();
    std::vector<NodeId> nodes = all_nodes(structure.model());
    if (check.point) nodes = {*check.point};
    else if (check.curve) nodes = nodes_of_curve(structure, *check.curve);
    if (*check.component == PlaneComponent::mz) return result.reaction_moment(nodes, place_or_origin(check.about));
    const Eigen::Vector2d force = result.reaction(nodes);
    return *check.component == PlaneComponent::fx ? force.x() : force.y();
}

double resultant_value(const PlaneCase& result, const PlaneExpected& check)
{
    const CutForces forces = result.forces({{check.cut[0], check.cut[1]}, {check.cut[2], check.cut[3]}});
    if (*check.component == PlaneComponent::N) return forces.N;
    return *check.component == PlaneComponent::V ? forces.V : forces.M;
}

double displacement_value(const PlaneResults& results, const PlaneCase& result, const PlaneExpected& check)
{
    const Eigen::Vector2d u = check.point ? result.displacement(*check.point)
                                          : result.displacement(locations_of(results, check).front());
    return component(u, *check.component, place_of(results.model(), check), place_or_origin(check.about));
}

/// Keeps the larger or smaller of what it is shown.
class ExtremeSearch {
public:
    ExtremeSearch(const ExtremeQuestion& question) : question_(question)
    {
        const double infinite = std::numeric_limits<double>::infinity();
        found_.value = question.which == ExtremeKind::Max ? -infinite : infinite;
    }
    void see(const Eigen::Vector2d& at, const PlaneStress& stress)
    {
        const double value = component(stress, question_.component, at, question_.about);
        const bool is_new = question_.which == ExtremeKind::Max ? value > found_.value : value < found_.value;
        if (is_new) found_ = {.value = value, .at = at};
    }
    const PlaneExtreme& found() const { return found_; }

private:
    const ExtremeQuestion& question_;
    PlaneExtreme found_;
};

} // namespace

std::vector<Location> locations_of(const PlaneResults& results, const PlaneExpected& check)
{
    if (!check.point) return results.locator().find({check.at[0], check.at[1]});
    std::vector<Location> all;
    const PlaneModel& model = results.model();
    for (std::size_t e = 0; e < model.elements.size(); ++e)
        for (std::size_t i = 0; i < model.elements[e].points.size(); ++i)
            if (model.elements[e].points[i] == *check.point)
                all.push_back({.element = ElementId(e), .at = shape_of(model.elements[e].kind).nodes()[i]});
    return all;
}

PlaneExtreme extreme(const PlaneCase& result, const ExtremeQuestion& question)
{
    const PlaneStructure& structure = result.structure();
    const PlaneModel& model = structure.model();
    std::vector<bool> is_wanted(model.points.size(), !question.curve);
    if (question.curve)
        for (const NodeId node : nodes_of_curve(structure, *question.curve)) is_wanted[node.index] = true;
    ExtremeSearch search(question);
    std::vector<std::vector<RegionId>> seen(model.points.size());
    for (std::size_t e = 0; e < model.elements.size(); ++e) {
        const PlaneElement& element = model.elements[e];
        if (question.region && element.region != *question.region) continue;
        if (question.read == StressReading::Gauss) {
            const bool is_there = std::ranges::any_of(element.points,
                                                      [&](NodeId node) { return is_wanted[node.index]; });
            if (is_there)
                result.at_integration_points(ElementId(e), [&](const Eigen::Vector2d& at, const PlaneStress& stress) {
                    search.see(at, stress);
                });
            continue;
        }
        for (std::size_t i = 0; i < element.points.size(); ++i) {
            const NodeId node = element.points[i];
            auto& regions = seen[node.index];
            if (!is_wanted[node.index] || std::ranges::find(regions, element.region) != regions.end()) continue;
            regions.push_back(element.region);
            const Location here{.element = ElementId(e), .at = shape_of(element.kind).nodes()[i]};
            search.see(structure.positions()[node.index], question.read == StressReading::Element
                                                              ? result.element_stress(node, element.region)
                                                              : result.smoothed_stress(here));
        }
    }
    return search.found();
}

double value_of(const PlaneResults& results, const PlaneCase& result, const PlaneExpected& check)
{
    switch (check.quantity) {
    case PlaneQuantity::Displacement: return displacement_value(results, result, check);
    case PlaneQuantity::Stress: return stress_value(results, result, check);
    case PlaneQuantity::Strain: return strain_value(results, result, check);
    case PlaneQuantity::Extreme:
        return extreme(result, {.component = *check.component,
                                .which = *check.extreme,
                                .read = check.read.value_or(StressReading::Smoothed),
                                .region = check.region,
                                .curve = check.curve,
                                .about = place_or_origin(check.about)})
            .value;
    case PlaneQuantity::Reaction: return reaction_value(result, check);
    case PlaneQuantity::Resultant: return resultant_value(result, check);
    case PlaneQuantity::Energy: return result.energy();
    default: throw std::logic_error("value_of: not a result of the linear analysis");
    }
}

} // namespace femoop::plane
