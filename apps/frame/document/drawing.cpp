#include "apps/frame/document/drawing.h"

#include <algorithm>
#include <map>

#include "femoop/edit/draw.h"
#include "femoop/edit/erase.h"
#include "femoop/edit/member_line.h"
#include "femoop/edit/merge.h"
#include "femoop/edit/naming.h"
#include "femoop/model/quantity/in_units.h"

namespace frame {

using femoop::Model;

namespace {

Eigen::Vector3d in_space(const Eigen::Vector2d& place) { return {place.x(), place.y(), 0.0}; }

/// The material and the section that the first member of a new model gets, in the model's units.
Model first_properties(const Model& model)
{
    Model plane = starting_document().model;
    femoop::Section& section = plane.sections.front();
    const bool twists = model.analysis == femoop::AnalysisKind::Grillage ||
                        model.analysis == femoop::AnalysisKind::Frame3d;
    if (twists) section.J = 3e-6;
    if (model.analysis == femoop::AnalysisKind::Frame3d) section.Iy = 7e-5;
    return in_units(plane, model.units);
}

/// What the next member is made like; of the first material and section where the model has none.
femoop::Member pattern(Model& model)
{
    if (model.materials.empty()) model.add(first_properties(model).materials.front());
    if (model.sections.empty()) model.add(first_properties(model).sections.front());
    return like_last_member(model);
}

/// Erases entries of a list by their places.
template <class Entry> void erase_places(std::vector<Entry>& list, std::vector<std::size_t> places)
{
    std::ranges::sort(places, std::ranges::greater());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (const std::size_t place : places) list.erase(list.begin() + static_cast<std::ptrdiff_t>(place));
}

/// The places of the loads of one kind in one load case.
template <class Place> std::vector<std::size_t> places_in(std::span<const Part> parts, std::size_t load_case)
{
    std::vector<std::size_t> places;
    for (const Part& part : parts)
        if (const auto* const place = std::get_if<Place>(&part); place && place->load_case == load_case) {
            if constexpr (std::is_same_v<Place, SettlementPlace>) places.push_back(place->settlement);
            else places.push_back(place->load);
        }
    return places;
}

void remove_loads(Model& model, std::span<const Part> parts)
{
    for (std::size_t i = 0; i < model.load_cases.size(); ++i) {
        femoop::LoadCase& load_case = model.load_cases[i];
        erase_places(load_case.nodes, places_in<NodeLoadPlace>(parts, i));
        erase_places(load_case.settlements, places_in<SettlementPlace>(parts, i));
        erase_places(load_case.members, places_in<MemberLoadPlace>(parts, i));
    }
}

/// Of the other parts, those that femoop erases.
class ToErase {
public:
    explicit ToErase(const Model& model) : model_(model) {}

    void operator()(femoop::NodeId id) { node_names.push_back(model_[id].id); }
    void operator()(femoop::MemberId id) { parts.members.push_back(id); }
    void operator()(femoop::MaterialId id)
    {
        if (!is_used(model_, id)) parts.materials.push_back(id);
    }
    void operator()(femoop::SectionId id)
    {
        if (!is_used(model_, id)) parts.sections.push_back(id);
    }
    void operator()(LoadCasePlace place) { parts.cases.emplace_back(place.load_case); }
    void operator()(CombinationPlace place) { parts.cases.emplace_back(model_.load_cases.size() + place.combination); }
    template <class OtherPlace> void operator()(const OtherPlace&) {} // loads and dimension lines are seen to elsewhere

    femoop::Parts parts;
    std::vector<std::string> node_names; ///< nodes go last, and then have other ids

private:
    const Model& model_;
};

void remove_dimensions(Companion& companion, std::span<const Part> parts)
{
    std::vector<std::size_t> places;
    for (const Part& part : parts)
        if (const auto* const place = std::get_if<DimensionPlace>(&part)) places.push_back(place->dimension);
    erase_places(companion.dimensions, std::move(places));
}

/// Changes the model, and the companion follows.
template <class Edit> void edit_model(Document& document, Edit&& edit)
{
    if (document.companion.is_empty()) return edit(document.model);
    const Model before = document.model;
    edit(document.model);
    follow(document.companion, before, document.model);
}

femoop::Parts structural(std::span<const Part> parts)
{
    femoop::Parts found;
    for (const Part& part : parts) {
        if (const auto* const node = std::get_if<femoop::NodeId>(&part)) found.nodes.push_back(*node);
        if (const auto* const member = std::get_if<femoop::MemberId>(&part)) found.members.push_back(*member);
    }
    return found;
}

/// Erases the node, unless two equal members go on straight there: these become one.
void take_out(Model& model, const std::string& node_name)
{
    const std::optional<femoop::NodeId> node = model.find_node(node_name);
    if (!node) return;
    if (why_not_merge_at(model, *node)) femoop::erase(model, {.nodes = {*node}});
    else merge_members_at(model, *node);
}

} // namespace

femoop::Member like_last_member(const Model& model)
{
    femoop::Member member;
    if (!model.members.empty()) {
        const femoop::Member& last = model.members.back();
        member.material = last.material;
        member.section = last.section;
        member.theory = last.theory;
    }
    if (!member.material && !model.materials.empty()) member.material = femoop::MaterialId(model.materials.size() - 1);
    if (!member.section && !model.sections.empty()) member.section = femoop::SectionId(model.sections.size() - 1);
    return member;
}

void add_node(Document& document, const Eigen::Vector2d& place) { add_node_in_space(document, in_space(place)); }

void add_node_in_space(Document& document, const Eigen::Vector3d& place) { femoop::place_node(document.model, place); }

void draw_member(Document& document, const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                 femoop::Crossings crossings)
{
    draw_member_in_space(document, in_space(start), in_space(end), crossings);
}

void draw_member_in_space(Document& document, const Eigen::Vector3d& start, const Eigen::Vector3d& end,
                          femoop::Crossings crossings)
{
    if ((end - start).norm() <= femoop::nearness_of(document.model)) return;
    Model next = document.model;
    const femoop::Member like = pattern(next);
    femoop::draw_member(next, start, end, like, crossings);
    document.model = std::move(next);
}

void remove(Document& document, std::span<const Part> parts)
{
    ToErase erased(document.model);
    for (const Part& part : parts) std::visit(erased, part);
    remove_dimensions(document.companion, parts);
    edit_model(document, [&](Model& model) {
        remove_loads(model, parts);
        femoop::erase(model, erased.parts);
        for (const std::string& name : erased.node_names) take_out(model, name);
    });
}

std::vector<femoop::NodeId> nodes_of(const Model& model, std::span<const Part> parts)
{
    femoop::Parts found = structural(parts);
    for (const femoop::MemberId member : found.members)
        for (const femoop::NodeId node : model[member].nodes) found.nodes.push_back(node);
    std::ranges::sort(found.nodes);
    found.nodes.erase(std::unique(found.nodes.begin(), found.nodes.end()), found.nodes.end());
    return found.nodes;
}

namespace {

/// What nodes that are placed or copied together are called then; the others have no such name.
using Renaming = std::map<std::string, std::string>;

/// The same line for the new names of its nodes; nothing where one of them stays behind.
std::optional<DimensionLine> renamed(DimensionLine dimension, const Renaming& names)
{
    for (std::string& name : dimension.nodes) {
        const auto found = names.find(name);
        if (found == names.end()) return std::nullopt;
        name = found->second;
    }
    return dimension;
}

/// The nodes in the order in which femoop copies them.
std::vector<femoop::NodeId> copied_in_order(const Model& model, const femoop::Parts& parts)
{
    std::vector<femoop::NodeId> nodes = parts.nodes;
    for (const femoop::MemberId member : parts.members)
        for (const femoop::NodeId node : model[member].nodes)
            if (std::ranges::find(nodes, node) == nodes.end()) nodes.push_back(node);
    return nodes;
}

/// Copies parts with the dimension lines between them.
femoop::Parts copy_once(Document& document, femoop::Parts parts, const femoop::Placement& placement)
{
    Model& model = document.model;
    parts.nodes = copied_in_order(model, parts);
    const femoop::Parts copies = femoop::copy_parts(model, parts, placement);
    Renaming names;
    for (std::size_t i = 0; i < parts.nodes.size(); ++i) names[model[parts.nodes[i]].id] = model[copies.nodes.at(i)].id;
    std::vector<DimensionLine>& dimensions = document.companion.dimensions;
    const std::size_t n = dimensions.size();
    for (std::size_t i = 0; i < n; ++i)
        if (auto copied = renamed(placed(dimensions[i], model, placement), names))
            dimensions.push_back(std::move(*copied));
    return copies;
}

} // namespace

void place(Document& document, std::span<const Part> parts, const femoop::Placement& placement)
{
    const std::vector<femoop::NodeId> nodes = nodes_of(document.model, parts);
    Renaming names;
    for (const femoop::NodeId node : nodes) names[document.model[node].id] = document.model[node].id;
    for (DimensionLine& dimension : document.companion.dimensions)
        if (renamed(dimension, names)) dimension = placed(dimension, document.model, placement);
    femoop::place_nodes(document.model, nodes, placement);
}

std::vector<Part> copy(Document& document, std::span<const Part> parts, const femoop::Placement& placement, int times)
{
    femoop::Parts latest = structural(parts);
    for (int i = 0; i < times; ++i) latest = copy_once(document, std::move(latest), placement);
    std::vector<Part> copies(latest.nodes.begin(), latest.nodes.end());
    copies.insert(copies.end(), latest.members.begin(), latest.members.end());
    return copies;
}

void join(Document& document, const Model& before, const femoop::Welding& welding)
{
    edit_model(document, [&](Model& model) { femoop::weld(model, before, welding); });
}

void join(Document& document, Selection& selection, const Model& before, const femoop::Welding& welding)
{
    const Document apart = document;
    join(document, before, welding);
    selection.follow(apart, document);
}

void rename(Document& document, const Model& before)
{
    const std::vector<femoop::Node> were = document.model.nodes;
    femoop::rename(document.model, before);
    Renaming names;
    for (std::size_t i = 0; i < were.size(); ++i) names[were[i].id] = document.model.nodes[i].id;
    for (DimensionLine& dimension : document.companion.dimensions)
        if (auto line = renamed(dimension, names)) dimension = *std::move(line);
}

} // namespace frame
