#include "apps/drawing/loads/loads.h"

#include <map>

namespace drawing {

namespace {

using Stacks = std::map<femoop::MemberId, LoadStack>;

/// Calls `draw` for every load of one kind, with its member and what it is measured by.
template <class Load, class Draw>
void for_each(const std::vector<CaseTerm>& terms, const LargestLoads& largest, Draw&& draw)
{
    for (const CaseTerm& term : terms) {
        const std::vector<femoop::MemberLoad>& loads = term.load_case->members;
        for (std::size_t i = 0; i < loads.size(); ++i)
            if (const auto* wanted = std::get_if<Load>(&loads[i].load))
                draw(loads[i].member, *wanted, LoadScale{largest, term.factor, MemberLoadPlace{term.place, i}});
    }
}

void draw_member_loads(const Scene& scene, const std::vector<CaseTerm>& terms, const LargestLoads& largest)
{
    Stacks stacks;
    for_each<femoop::TemperatureLoad>(terms, largest, [&](auto member, const auto& load, const LoadScale& scale) {
        draw_temperature(scene, member, load, scale.factor, stacks[member]);
    });
    for_each<femoop::Misfit>(terms, largest, [&](auto member, const auto& load, const LoadScale& scale) {
        draw_misfit(scene, member, load, scale.factor);
    });
    // Loads per projected length stand off the member, above those that lie on it.
    for (const bool projected : {false, true})
        for_each<femoop::DistributedLoad>(terms, largest, [&](auto member, const auto& load, const LoadScale& scale) {
            if (load.projected == projected) draw_line_load(scene, member, load, scale, stacks[member]);
        });
    for_each<femoop::PointLoad>(terms, largest, [&](auto member, const auto& load, const LoadScale& scale) {
        draw_point_load(scene, member, load, scale, stacks[member]);
    });
    for_each<femoop::EndLoads>(terms, largest, [&](auto member, const auto& load, const LoadScale& scale) {
        draw_end_loads(scene, member, load, scale);
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
        const std::vector<femoop::NodeLoad>& loads = term.load_case->nodes;
        for (std::size_t i = 0; i < loads.size(); ++i)
            draw_node_load(scene, loads[i], {largest, term.factor, NodeLoadPlace{term.place, i}});
        for (const auto& settlement : term.load_case->settlements) draw_settlement(scene, settlement, term.factor);
    }
}

} // namespace drawing
