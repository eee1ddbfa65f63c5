#include "apps/frame/document/coordinate_limit.h"

#include <algorithm>
#include <cmath>

#include "femoop/edit/member_line.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/quantity_parser.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;

namespace {

double distance_of(const Node& node)
{
    const auto size = [&](int i) { return std::abs(node.at[static_cast<std::size_t>(i)].value()); };
    return std::max({size(0), size(1), size(2)});
}

double round_below(double length) { return std::pow(10.0, std::floor(std::log10(length))); }

double coordinate_limit(const Model& model)
{
    constexpr double furthest = 1e6; // m
    // The extent is then at most three such distances, and places are one that are nearer than a third of the member.
    constexpr double of_shortest_member = 1e5;
    static_assert(3.0 * of_shortest_member * relative_nearness < 0.5);
    const double nearness = nearness_of(model);
    double limit = converted(furthest, dimension::length, {}, model.units);
    for (const Member& member : model.members) {
        const double length = geometry_of(model, member).length;
        if (length > nearness) limit = std::min(limit, round_below(of_shortest_member * length));
    }
    for (const Node& node : model.nodes) limit = std::max(limit, distance_of(node));
    return limit;
}

} // namespace

std::optional<ui::Message> why_beyond_coordinate_limit(const Model& before, const Model& after)
{
    const double limit = coordinate_limit(before);
    const auto far = std::ranges::find_if(after.nodes, [&](const Node& node) { return !(distance_of(node) <= limit); });
    if (far == after.nodes.end()) return std::nullopt;
    const auto length = [&](double value) { return quantity_text(value, dimension::length, after.units); };
    return ui::Message(
        ui::translatable(
            "nothing was changed: node {id} would lie {distance} off, where nodes beside each other are one; "
            "stay within {reach}, and check the unit"),
        {{"id", far->id}, {"distance", length(distance_of(*far))}, {"reach", length(limit)}});
}

} // namespace frame
