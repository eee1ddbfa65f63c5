#include "apps/drawing/loads/loads.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>
#include <vector>

#include "femoop/load/case_terms.h"

namespace drawing {

namespace {

using femoop::LoadComponent;
using Term = femoop::CaseTerms::Term;

/// Calls `act` for every load on a member, with its case's factor and its place in the model.
template <class Act> void for_each_member_load(const femoop::Model& model, const std::vector<Term>& terms, Act&& act)
{
    for (const Term& term : terms) {
        const std::vector<femoop::MemberLoad>& loads = model.load_cases[term.load_case].members;
        for (std::size_t i = 0; i < loads.size(); ++i) act(loads[i], term.factor, MemberLoadPlace{term.load_case, i});
    }
}

std::vector<ShownLoad> shown_loads(const Scene& scene, const std::vector<Term>& terms)
{
    std::vector<ShownLoad> shown;
    for_each_member_load(scene.model, terms, [&](const auto& load, double factor, const MemberLoadPlace& place) {
        for (LoadComponent component : femoop::components_of(load, scene.shape[load.member].length)) {
            component.start *= factor;
            component.end *= factor;
            shown.push_back({load.member, component, place});
        }
    });
    return shown;
}

/// A line load of one value over all of a line of members, straight or bent as an arch is, needs to be written at the
/// longest of them alone.
class Repeats {
public:
    Repeats(const Scene& scene, const std::vector<ShownLoad>& shown) : scene_(scene), shown_(shown)
    {
        for (std::size_t i = 0; i < shown.size(); ++i)
            if (is_even(shown[i])) at_[shown[i].member].push_back(i);
    }

    bool contains(std::size_t index) const
    {
        const ShownLoad& load = shown_[index];
        if (!is_even(load)) return false;
        for (const femoop::NodeId node : scene_.model[load.member].nodes)
            for (const femoop::MemberId other : scene_.shape.members_at[node.index])
                if (goes_straight_on(node, load.member, other) && is_written_at(other, index)) return true;
        return false;
    }

private:
    bool is_seen(femoop::MemberId member) const
    {
        const MemberShape& shape = scene_.shape[member];
        return scene_.sketch.is_in_sight(scene_.projection(shape.at(0.5 * shape.length)));
    }

    double length(const ShownLoad& load) const { return scene_.shape[load.member].length; }

    bool is_even(const ShownLoad& load) const
    {
        const LoadComponent& component = load.component;
        constexpr double nearly = 1e-9;
        return component.kind == LoadComponent::Kind::Line && component.start == component.end &&
               component.to - component.from > (1.0 - nearly) * length(load);
    }

    bool goes_straight_on(femoop::NodeId node, femoop::MemberId member, femoop::MemberId other) const
    {
        constexpr double straight = -0.96; // the chords of an arch turn by less, the rafters of a roof by more
        if (member == other) return false;
        const auto away = [&](femoop::MemberId id) { return direction_from(scene_.shape, scene_.model, node, id); };
        return away(member).dot(away(other)) < straight;
    }

    bool is_written_at(femoop::MemberId other, std::size_t index) const
    {
        const auto found = at_.find(other);
        return found != at_.end() && is_seen(other) && std::ranges::any_of(found->second, [&](std::size_t at) {
                   return is_same(shown_[at], shown_[index]) && is_before(at, index);
               });
    }

    bool is_same(const ShownLoad& a, const ShownLoad& b) const
    {
        const auto force = [&](const ShownLoad& load) -> Eigen::Vector3d {
            return load.component.start * femoop::direction_of(load.component, scene_.shape[load.member]);
        };
        return a.component.dof == b.component.dof && a.component.is_projected == b.component.is_projected &&
               force(a).isApprox(force(b));
    }

    bool is_before(std::size_t a, std::size_t b) const
    {
        const double longer = length(shown_[a]) - length(shown_[b]);
        constexpr double alike = 1e-6;
        return std::abs(longer) > alike * length(shown_[b]) ? longer > 0.0 : a < b;
    }

    const Scene& scene_;
    const std::vector<ShownLoad>& shown_;
    std::map<femoop::MemberId, std::vector<std::size_t>> at_;
};

void mark_repeats(const Scene& scene, std::vector<ShownLoad>& shown)
{
    const Repeats repeats(scene, shown);
    for (std::size_t i = 0; i < shown.size(); ++i) shown[i].is_repeat = repeats.contains(i);
}

void raise(double& largest, double value)
{
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
}

LargestLoads largest_of(const femoop::Model& model, const std::vector<Term>& terms, const std::vector<ShownLoad>& shown)
{
    LargestLoads largest;
    for (const Term& term : terms)
        for (const femoop::NodeLoad& load : model.load_cases[term.load_case].nodes)
            for (const femoop::Component& c : load.components)
                if (!femoop::is_rotation(c.dof)) raise(largest.force, term.factor * c.value);
    for (const ShownLoad& load : shown) {
        if (femoop::is_rotation(load.component.dof)) continue;
        double& of_kind = load.component.kind == LoadComponent::Kind::Line ? largest.per_length : largest.force;
        raise(of_kind, load.component.start);
        raise(of_kind, load.component.end);
    }
    return largest;
}

/// The order in which they are drawn. Loads per projected length stand off the member, above those that lie on it.
int turn_of(const LoadComponent& component)
{
    if (component.kind == LoadComponent::Kind::Line) return component.is_projected ? 1 : 0;
    return component.kind == LoadComponent::Kind::Point ? 2 : 3;
}

void draw_member_loads(const Scene& scene, const std::vector<Term>& terms, std::vector<ShownLoad> shown,
                       const LargestLoads& largest)
{
    std::map<femoop::MemberId, LoadStack> stacks, points;
    for_each_member_load(scene.model, terms, [&](const auto& load, double factor, const MemberLoadPlace& /*place*/) {
        if (const auto* const heat = std::get_if<femoop::TemperatureLoad>(&load.load))
            draw_temperature(scene, load.member, *heat, factor, stacks[load.member]);
    });
    for_each_member_load(scene.model, terms, [&](const auto& load, double factor, const MemberLoadPlace& /*place*/) {
        if (const auto* const misfit = std::get_if<femoop::Misfit>(&load.load))
            draw_misfit(scene, load.member, *misfit, factor);
    });
    std::ranges::stable_sort(shown, {}, [](const ShownLoad& load) { return turn_of(load.component); });
    for (const ShownLoad& load : shown) {
        if (load.component.kind == LoadComponent::Kind::Line) draw_line_load(scene, load, largest, stacks[load.member]);
        else draw_point_load(scene, load, largest, stacks[load.member], points[load.member]);
    }
}

} // namespace

void draw_loads(const Scene& scene)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    const std::vector<Term> terms = femoop::terms_of(scene.model, scene.options.load_case).terms;
    std::vector<ShownLoad> shown = shown_loads(scene, terms);
    mark_repeats(scene, shown);
    const LargestLoads largest = largest_of(scene.model, terms, shown);
    draw_member_loads(scene, terms, std::move(shown), largest);
    std::map<femoop::NodeId, LoadStack> points;
    for (const Term& term : terms) {
        const femoop::LoadCase& load_case = scene.model.load_cases[term.load_case];
        for (std::size_t i = 0; i < load_case.nodes.size(); ++i)
            draw_node_load(scene, load_case.nodes[i], {largest, term.factor, NodeLoadPlace{term.load_case, i}},
                           points[load_case.nodes[i].node]);
        for (const auto& settlement : load_case.settlements) draw_settlement(scene, settlement, term.factor);
    }
}

} // namespace drawing
