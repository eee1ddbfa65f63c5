#include "apps/frame/tables/new_row.h"

#include <algorithm>

#include "apps/frame/document/drawing.h"
#include "apps/frame/document/loading.h"
#include "apps/frame/document/overloaded.h"
#include "femoop/edit/insert.h"
#include "femoop/edit/naming.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;

namespace {

Part append_load(Document& document, TableKind kind)
{
    const LoadCasePlace place = load_case_for(document, CaseId(0));
    LoadCase& load_case = document.model.load_cases[place.load_case];
    const auto member_load = [&](const decltype(MemberLoad::load)& load) -> Part {
        return add_member_load(document, place, MemberId(0), load);
    };
    switch (kind) {
    case TableKind::NodeLoads:
        load_case.nodes.push_back({});
        return NodeLoadPlace{place.load_case, load_case.nodes.size() - 1};
    case TableKind::Settlements:
        load_case.settlements.push_back({});
        return SettlementPlace{place.load_case, load_case.settlements.size() - 1};
    case TableKind::DistributedLoads: return member_load(DistributedLoad{});
    case TableKind::PointLoads: return member_load(PointLoad{.at = Percent{50.0}, .components = {}});
    case TableKind::EndLoads: return member_load(EndLoads{});
    case TableKind::Temperatures: return member_load(TemperatureLoad{});
    default: return member_load(Misfit{});
    }
}

Part append_load_case(Model& model)
{
    return LoadCasePlace{femoop::insert_load_case(model, fresh_case_id(model, "1")).index};
}

} // namespace

Part append(Document& document, TableKind kind)
{
    Model& model = document.model;
    switch (kind) {
    case TableKind::Nodes: {
        Node node;
        node.id = fresh_node_id(model);
        return model.add(std::move(node));
    }
    case TableKind::Members: return model.add(like_last_member(model));
    case TableKind::LoadCases: return append_load_case(model);
    case TableKind::Combinations:
        model.combinations.push_back({.id = fresh_case_id(model, "C"), .terms = {}});
        return CombinationPlace{model.combinations.size() - 1};
    case TableKind::Materials: return model.add(Material{});
    case TableKind::Sections: return model.add(Section{});
    default: return append_load(document, kind);
    }
}

void give_name(Model& model, const Part& part)
{
    const auto* const id = std::get_if<MemberId>(&part);
    if (id == nullptr || !model[*id].id.empty()) return;
    Member member = std::move(model.members[id->index]);
    model.members.erase(model.members.begin() + id->index);
    member.id = fresh_member_id(model, member.nodes[0], member.nodes[1]);
    model.members.insert(model.members.begin() + id->index, std::move(member));
}

namespace {

bool has_value(const MemberLoad& load)
{
    return std::visit(Overloaded{[](const DistributedLoad& l) { return !l.values.empty(); },
                                 [](const PointLoad& l) { return !l.components.empty(); },
                                 [](const EndLoads& l) { return !l.start.empty() || !l.end.empty(); },
                                 [](const auto&) { return true; }},
                      load.load);
}

bool has_value(const Model& model, const Part& part)
{
    if (const auto* const p = std::get_if<NodeLoadPlace>(&part))
        return !model.load_cases[p->load_case].nodes[p->load].components.empty();
    if (const auto* const p = std::get_if<SettlementPlace>(&part))
        return !model.load_cases[p->load_case].settlements[p->settlement].components.empty();
    if (const auto* const p = std::get_if<MemberLoadPlace>(&part))
        return has_value(model.load_cases[p->load_case].members[p->load]);
    return true;
}

template <class Entries> std::optional<std::string> double_in(const Entries& list, std::size_t place)
{
    const std::string& name = list[place].id;
    const auto n = std::ranges::count_if(list, [&](const auto& other) { return other.id == name; });
    return n > 1 ? std::optional(name) : std::nullopt;
}

// Load cases and combinations share one set of names.
std::optional<std::string> double_case(const Model& model, CaseId id)
{
    std::size_t n = 0;
    for (std::size_t i = 0; i < model.n_cases(); ++i)
        if (model.case_name(CaseId(i)) == model.case_name(id)) ++n;
    return n > 1 ? std::optional(model.case_name(id)) : std::nullopt;
}

} // namespace

std::optional<std::string> why_not_row(const Model& model, const Part& part, const ui::Catalogue& tr)
{
    if (const auto* const id = std::get_if<MemberId>(&part); id && model[*id].nodes[0] == model[*id].nodes[1])
        return tr("the member starts and ends at one node");
    if (const auto* const p = std::get_if<CombinationPlace>(&part);
        p && model.combinations[p->combination].terms.empty())
        return tr("the combination has no factor; give it one or delete its row");
    if (!has_value(model, part)) return tr("the load has no value; give it one or delete its row");
    return std::nullopt;
}

std::optional<std::string> double_name(const Model& model, const Part& part)
{
    if (const auto* const id = std::get_if<NodeId>(&part)) return double_in(model.nodes, id->index);
    if (const auto* const id = std::get_if<MemberId>(&part)) return double_in(model.members, id->index);
    if (const auto* const id = std::get_if<MaterialId>(&part)) return double_in(model.materials, id->index);
    if (const auto* const id = std::get_if<SectionId>(&part)) return double_in(model.sections, id->index);
    if (const auto* const p = std::get_if<LoadCasePlace>(&part)) return double_case(model, CaseId(p->load_case));
    if (const auto* const p = std::get_if<CombinationPlace>(&part))
        return double_case(model, CaseId(model.load_cases.size() + p->combination));
    return std::nullopt;
}

namespace {

// Takes out the entry at a place of a list.
template <class Entry> Entry taken(std::vector<Entry>& list, std::size_t place)
{
    Entry entry = std::move(list[place]);
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(place));
    return entry;
}

using AnyLoad = std::variant<NodeLoad, Settlement, MemberLoad>;

AnyLoad taken(Model& model, const Part& load)
{
    if (const auto* const p = std::get_if<NodeLoadPlace>(&load))
        return taken(model.load_cases[p->load_case].nodes, p->load);
    if (const auto* const p = std::get_if<SettlementPlace>(&load))
        return taken(model.load_cases[p->load_case].settlements, p->settlement);
    const auto& p = std::get<MemberLoadPlace>(load);
    return taken(model.load_cases[p.load_case].members, p.load);
}

void put(LoadCase& load_case, AnyLoad load)
{
    std::visit(Overloaded{[&](NodeLoad& l) { load_case.nodes.push_back(std::move(l)); },
                          [&](Settlement& l) { load_case.settlements.push_back(std::move(l)); },
                          [&](MemberLoad& l) { load_case.members.push_back(std::move(l)); }},
               load);
}

} // namespace

void move_loads(Document& document, std::vector<CaseMove> moves)
{
    std::ranges::sort(moves, {}, &CaseMove::load);
    std::vector<AnyLoad> loads;
    for (auto move = moves.rbegin(); move != moves.rend(); ++move) // from the back, so that places stay
        loads.push_back(taken(document.model, move->load));
    for (const CaseMove& move : moves) {
        put(document.model.load_cases[move.load_case], std::move(loads.back()));
        loads.pop_back();
    }
}

} // namespace frame
