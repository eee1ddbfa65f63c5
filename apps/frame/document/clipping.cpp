#include "apps/frame/document/clipping.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "apps/frame/document/drawing.h"
#include "apps/frame/document/fault/place.h"
#include "femoop/edit/condense.h"
#include "femoop/edit/erase.h"
#include "femoop/edit/excerpt.h"
#include "femoop/edit/insert.h"
#include "femoop/edit/naming.h"
#include "femoop/edit/place.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/model/check/check.h"
#include "femoop/model/quantity/in_units.h"
#include "femoop/model/quantity/quantity_parser.h"
#include "ui/text/catalogue.h"

namespace frame {

using Eigen::Vector3d;
using femoop::CaseId;
using femoop::LoadCase;
using femoop::MemberId;
using femoop::Model;
using femoop::NodeId;
using ui::translatable;

namespace {

bool is_structural(const Part& part)
{
    return std::holds_alternative<NodeId>(part) || std::holds_alternative<MemberId>(part);
}

bool is_load(const Part& part)
{
    return std::holds_alternative<NodeLoadPlace>(part) || std::holds_alternative<MemberLoadPlace>(part) ||
           std::holds_alternative<SettlementPlace>(part);
}

/// Takes out all loads but these.
void keep_loads(Model& model, const std::set<Part>& kept)
{
    const auto thin = [&](auto& list, auto place) {
        std::size_t i = 0;
        std::erase_if(list, [&](const auto&) { return !kept.contains(place(i++)); });
    };
    for (std::size_t c = 0; c < model.load_cases.size(); ++c) {
        LoadCase& load_case = model.load_cases[c];
        thin(load_case.nodes, [c](std::size_t i) -> Part { return NodeLoadPlace{c, i}; });
        thin(load_case.settlements, [c](std::size_t i) -> Part { return SettlementPlace{c, i}; });
        thin(load_case.members, [c](std::size_t i) -> Part { return MemberLoadPlace{c, i}; });
    }
}

/// Takes out what no selected node or member needs: other nodes and members, materials, sections.
void keep_structure(Model& model, const std::vector<NodeId>& nodes, const std::set<MemberId>& members)
{
    femoop::Parts others;
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if (!std::ranges::binary_search(nodes, NodeId(i))) others.nodes.emplace_back(i);
    for (std::size_t i = 0; i < model.members.size(); ++i)
        if (!members.contains(MemberId(i))) others.members.emplace_back(i);
    femoop::erase(model, others);
    femoop::condense(model);
}

/// Takes out cases that are about the structure as a whole: empty ones, and combinations.
void keep_loaded_cases(Model& model)
{
    model.combinations.clear();
    std::erase_if(model.load_cases, [](const LoadCase& load_case) {
        return load_case.nodes.empty() && load_case.members.empty() && load_case.settlements.empty();
    });
}

/// The bearers of loads, as if they were selected.
std::vector<Part> bearers_of(const Model& model, const std::vector<Part>& loads)
{
    std::vector<Part> bearers;
    for (const Part& part : loads) {
        const LoadCase& load_case = model.load_cases[load_case_of(part)];
        if (const auto* const p = std::get_if<NodeLoadPlace>(&part))
            bearers.emplace_back(load_case.nodes[p->load].node);
        if (const auto* const p = std::get_if<SettlementPlace>(&part))
            bearers.emplace_back(load_case.settlements[p->settlement].node);
        if (const auto* const p = std::get_if<MemberLoadPlace>(&part))
            bearers.emplace_back(load_case.members[p->load].member);
    }
    return bearers;
}

/// Those that measure between nodes of the model alone.
std::vector<DimensionLine> lines_between(const Model& model, const std::vector<DimensionLine>& lines)
{
    std::vector<DimensionLine> between;
    const auto is_node = [&](const std::string& name) { return model.find_node(name).has_value(); };
    std::ranges::copy_if(lines, std::back_inserter(between),
                         [&](const DimensionLine& line) { return std::ranges::all_of(line.nodes, is_node); });
    return between;
}

} // namespace

bool can_be_clipped(const Part& part) { return is_structural(part) || is_load(part); }

std::optional<Clipping> clipping_of(const Document& document, std::span<const Part> parts)
{
    const Model& model = document.model;
    std::vector<Part> structure, loads;
    std::ranges::copy_if(parts, std::back_inserter(structure), is_structural);
    std::ranges::copy_if(parts, std::back_inserter(loads), is_load);
    if (structure.empty() && loads.empty()) return std::nullopt;
    Clipping clipping{.model = femoop::structure_alone(model)};
    if (structure.empty()) {
        clipping.holds = Clipping::Holds::Loads;
        structure = bearers_of(model, loads);
        keep_loads(clipping.model, {loads.begin(), loads.end()});
    }
    std::set<MemberId> members;
    for (const Part& part : structure)
        if (const auto* const member = std::get_if<MemberId>(&part)) members.insert(*member);
    const std::vector<NodeId> nodes = nodes_of(model, structure);
    keep_structure(clipping.model, nodes, members);
    const bool is_whole = nodes.size() == model.nodes.size() && members.size() == model.members.size();
    const bool holds_structure = clipping.holds == Clipping::Holds::Structure;
    if (!holds_structure || !is_whole) keep_loaded_cases(clipping.model);
    if (holds_structure) clipping.dimensions = lines_between(clipping.model, document.companion.dimensions);
    return clipping;
}

std::vector<femoop::Fault> weightless(const Model& model, const Clipping& clipping)
{
    Document trial{.model = model, .companion = {}};
    if (clipping.holds == Clipping::Holds::Structure) paste(trial, clipping, Vector3d::Zero());
    std::vector<femoop::Fault> faults = named(femoop::check(trial.model), trial.model);
    const std::vector<femoop::Fault> known = named(femoop::check(model), model);
    std::erase_if(faults, [&](const femoop::Fault& fault) {
        return fault.kind != femoop::FaultKind::MissingDensity || std::ranges::find(known, fault) != known.end();
    });
    return faults;
}

std::optional<ui::Message> why_not_paste(const Model& model, std::span<const Part> selected, const Clipping& clipping)
{
    const bool is_alike = clipping.model.analysis == model.analysis;
    if (!is_alike && !model.nodes.empty()) return translatable("what was copied is of another kind of structure");
    if (clipping.holds == Clipping::Holds::Loads && std::ranges::none_of(selected, is_structural))
        return translatable("loads were copied; select the nodes or members that get them");
    return std::nullopt;
}

namespace {

Vector3d grip_in(const Model& model)
{
    Vector3d grip = femoop::position_of(model, NodeId(0));
    for (std::size_t i = 1; i < model.nodes.size(); ++i) {
        const Vector3d place = femoop::position_of(model, NodeId(i));
        if (std::ranges::lexicographical_compare(place, grip)) grip = place;
    }
    return grip;
}

} // namespace

Vector3d grip_of(const Clipping& clipping, const femoop::Units& units)
{
    return grip_in(femoop::in_units(clipping.model, units));
}

namespace {

void paste_dimensions(Document& document, const Clipping& clipping, const std::vector<NodeId>& nodes)
{
    for (DimensionLine line : clipping.dimensions) {
        for (std::string& name : line.nodes) name = document.model[nodes.at(clipping.model.find_node(name)->index)].id;
        line.offset = femoop::converted(line.offset, femoop::dimension::length, clipping.model.units,
                                        document.model.units);
        document.companion.dimensions.push_back(std::move(line));
    }
}

} // namespace

void paste(Document& document, const Clipping& clipping, const Vector3d& place)
{
    Model& model = document.model;
    if (model.nodes.empty()) model.analysis = clipping.model.analysis;
    Model copied = clipping.model;
    for (LoadCase& load_case : copied.load_cases) { // one of the same name is the same, whatever it does besides
        const auto there = std::ranges::find(model.load_cases, load_case.id, &LoadCase::id);
        if (there != model.load_cases.end()) load_case.self_weight = there->self_weight;
    }
    const Vector3d shift = place - grip_of(clipping, model.units);
    const femoop::Parts added = femoop::insert(model, copied, femoop::moved_by(shift));
    paste_dimensions(document, clipping, added.nodes);
}

namespace {

std::size_t place_of_case(Model& model, const LoadCase& wanted)
{
    const auto there = std::ranges::find(model.load_cases, wanted.id, &LoadCase::id);
    if (there != model.load_cases.end()) return static_cast<std::size_t>(there - model.load_cases.begin());
    return femoop::insert_load_case(model, femoop::fresh_case_id(model, wanted.id)).index;
}

} // namespace

void paste_loads(Document& document, const Clipping& clipping, std::span<const Part> bearers)
{
    const Model copied = femoop::in_units(clipping.model, document.model.units);
    for (const LoadCase& from : copied.load_cases) {
        LoadCase& to = document.model.load_cases[place_of_case(document.model, from)];
        const auto put = [](auto& list, auto load, auto bearer, auto to_whom) {
            load.*bearer = to_whom;
            list.push_back(std::move(load));
        };
        for (const Part& part : bearers) {
            if (const auto* const node = std::get_if<NodeId>(&part)) {
                for (const auto& load : from.nodes) put(to.nodes, load, &femoop::NodeLoad::node, *node);
                for (const auto& one : from.settlements) put(to.settlements, one, &femoop::Settlement::node, *node);
            }
            if (const auto* const member = std::get_if<MemberId>(&part))
                for (const auto& load : from.members) put(to.members, load, &femoop::MemberLoad::member, *member);
        }
    }
}

} // namespace frame
