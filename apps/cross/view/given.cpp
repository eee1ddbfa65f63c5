#include "apps/cross/view/given.h"

#include <cmath>
#include <utility>

#include "apps/cross/view/numbers.h"
#include "femoop/load/place_along.h"

namespace cross {

using femoop::Model;

namespace {

constexpr std::size_t most_members = 12;

double length_of(const Model& model, const femoop::Member& member)
{
    const femoop::Node &a = model[member.nodes[0]], &b = model[member.nodes[1]];
    return std::hypot(b.at[0].value() - a.at[0].value(), b.at[1].value() - a.at[1].value());
}

std::string lengths(const Model& model, const ui::DisplayUnits& units, const ui::Catalogue& tr)
{
    std::string list;
    for (const femoop::Member& member : model.members)
        list += (list.empty() ? "" : ", ") + member.id + " " +
                units.text(length_of(model, member), ui::Measure::Length);
    return tr("Lengths: {list}.", {{"list", list}});
}

std::string point_load(const Model& model, const femoop::MemberLoad& load, const ui::DisplayUnits& units,
                       const ui::Catalogue& tr)
{
    const auto* const point = std::get_if<femoop::PointLoad>(&load.load);
    if (point == nullptr) return "";
    double squares = 0.0;
    for (const femoop::Component& one : point->components)
        if (one.dof == femoop::Dof::ux || one.dof == femoop::Dof::uy) squares += std::pow(one.value.value(), 2);
    if (squares == 0.0) return "";
    const femoop::Member& member = model[load.member];
    const double at = femoop::written_place(point->at, length_of(model, member));
    return " " + tr("{member}: {force} at {distance} from {node}.",
                    {{"member", member.id},
                     {"force", units.text(std::sqrt(squares), ui::Measure::Force)},
                     {"distance", units.text(at, ui::Measure::Length)},
                     {"node", model[member.nodes[0]].id}});
}

std::string joint_moments(const Model& model, const femoop::NodeLoad& load, const ui::DisplayUnits& units,
                          const ui::Catalogue& tr)
{
    std::string words;
    for (const femoop::Component& one : load.components) {
        if (one.dof != femoop::Dof::rz || one.value.value() == 0.0) continue;
        const std::string &node = model[load.node].id,
                          amount = units.text(std::abs(one.value.value()), ui::Measure::Moment);
        words += " " + (one.value.value() < 0.0
                            ? tr("{node}: moment {moment} clockwise.", {{"node", node}, {"moment", amount}})
                            : tr("{node}: moment {moment} counter-clockwise.", {{"node", node}, {"moment", amount}}));
    }
    return words;
}

} // namespace

std::string given_text(const Model& model, femoop::CaseId load_case, const ui::Catalogue& tr)
{
    if (model.members.empty() || model.members.size() > most_members) return "";
    const ui::DisplayUnits units = units_of(model, tr);
    std::string words = lengths(model, units, tr);
    if (load_case.index >= model.load_cases.size()) return words; // a combination
    const femoop::LoadCase& loads = model.load_cases[load_case.index];
    for (const femoop::MemberLoad& load : loads.members) words += point_load(model, load, units, tr);
    for (const femoop::NodeLoad& load : loads.nodes) words += joint_moments(model, load, units, tr);
    return words;
}

} // namespace cross
