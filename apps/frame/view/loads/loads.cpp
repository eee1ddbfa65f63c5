#include "apps/frame/view/loads/loads.h"

#include <map>

namespace frame {

namespace {

using Stacks = std::map<femoop::MemberId, LoadStack>;

/// Calls `draw` for every load of one kind, with its member and its case's factor.
template <class Load, class Draw> void for_each(const std::vector<CaseTerm>& terms, Draw&& draw)
{
    for (const CaseTerm& term : terms) {
        for (const femoop::MemberLoad& load : term.load_case->members)
            if (const auto* wanted = std::get_if<Load>(&load.load)) draw(load.member, *wanted, term.factor);
    }
}

void draw_member_loads(const Scene& scene, const std::vector<CaseTerm>& terms, const LargestLoads& largest)
{
    Stacks stacks;
    for_each<femoop::TemperatureLoad>(terms, [&](auto member, const auto& load, double factor) {
        draw_temperature(scene, member, load, factor, stacks[member]);
    });
    for_each<femoop::Misfit>(
        terms, [&](auto member, const auto& load, double factor) { draw_misfit(scene, member, load, factor); });
    // Loads per projected length stand off the member, above those that lie on it.
    for (const bool projected : {false, true})
        for_each<femoop::DistributedLoad>(terms, [&](auto member, const auto& load, double factor) {
            if (load.projected == projected) draw_line_load(scene, member, load, {largest, factor}, stacks[member]);
        });
    for_each<femoop::PointLoad>(terms, [&](auto member, const auto& load, double factor) {
        draw_point_load(scene, member, load, {largest, factor}, stacks[member]);
    });
    for_each<femoop::EndLoads>(terms, [&](auto member, const auto& load, double factor) {
        draw_end_loads(scene, member, load, {largest, factor});
    });
}

} // namespace

void draw_loads(const Scene& scene)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    const std::vector<CaseTerm> terms = terms_of(scene.model, scene.options.load_case);
    const LargestLoads largest = largest_loads(terms);
    draw_member_loads(scene, terms, largest);
    for (const CaseTerm& term : terms) {
        for (const auto& load : term.load_case->nodes) draw_node_load(scene, load, {largest, term.factor});
        for (const auto& settlement : term.load_case->settlements) draw_settlement(scene, settlement, term.factor);
    }
}

} // namespace frame
