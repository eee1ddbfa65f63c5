#include "apps/frame/tables/columns.h"

#include <sstream>

#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::translatable;

std::string_view title(TableKind kind)
{
    switch (kind) {
    case TableKind::Nodes: return translatable("Nodes");
    case TableKind::Members: return translatable("Members");
    case TableKind::Materials: return translatable("Materials");
    case TableKind::Sections: return translatable("Sections");
    case TableKind::Joints: return translatable("Releases and springs");
    case TableKind::LoadCases: return translatable("Load cases");
    case TableKind::Combinations: return translatable("Combinations");
    case TableKind::NodeLoads: return translatable("Loads on nodes");
    case TableKind::DistributedLoads: return translatable("Distributed loads");
    case TableKind::PointLoads: return translatable("Point loads");
    case TableKind::EndLoads: return translatable("End loads");
    case TableKind::Temperatures: return translatable("Temperatures");
    case TableKind::Misfits: return translatable("Misfits");
    case TableKind::Settlements: return translatable("Settlements");
    case TableKind::Displacements: return translatable("Displacements");
    case TableKind::Reactions: return translatable("Reactions");
    case TableKind::MemberEnds: return translatable("Member ends");
    case TableKind::Extremes: return translatable("Extremes");
    case TableKind::Envelope: return translatable("Envelope");
    case TableKind::ReactionEnvelope: break;
    }
    return translatable("Envelope of reactions");
}

std::vector<Column> columns(const Model& model, TableKind kind)
{
    switch (kind) {
    case TableKind::Nodes: return node_columns(model);
    case TableKind::Members: return member_columns(model);
    case TableKind::Materials: return material_columns();
    case TableKind::Sections: return section_columns();
    case TableKind::Joints: return joint_columns(model);
    case TableKind::LoadCases: return load_case_columns();
    case TableKind::Combinations: return combination_columns(model);
    default: return load_columns(model, kind);
    }
}

namespace {

template <class Id, class Entry> std::vector<Part> ids(const std::vector<Entry>& list)
{
    std::vector<Part> all;
    for (std::size_t i = 0; i < list.size(); ++i) all.emplace_back(Id(i));
    return all;
}

template <class Place, class Entry> std::vector<Part> places(const std::vector<Entry>& list)
{
    std::vector<Part> all;
    for (std::size_t i = 0; i < list.size(); ++i) all.emplace_back(Place{i});
    return all;
}

template <class Load> void add_member_loads(const LoadCase& load_case, std::size_t place, std::vector<Part>& all)
{
    for (std::size_t i = 0; i < load_case.members.size(); ++i)
        if (std::holds_alternative<Load>(load_case.members[i].load)) all.emplace_back(MemberLoadPlace{place, i});
}

void add_loads(const LoadCase& load_case, std::size_t place, TableKind kind, std::vector<Part>& all)
{
    switch (kind) {
    case TableKind::NodeLoads:
        for (std::size_t i = 0; i < load_case.nodes.size(); ++i) all.emplace_back(NodeLoadPlace{place, i});
        break;
    case TableKind::Settlements:
        for (std::size_t i = 0; i < load_case.settlements.size(); ++i) all.emplace_back(SettlementPlace{place, i});
        break;
    case TableKind::DistributedLoads: add_member_loads<DistributedLoad>(load_case, place, all); break;
    case TableKind::PointLoads: add_member_loads<PointLoad>(load_case, place, all); break;
    case TableKind::EndLoads: add_member_loads<EndLoads>(load_case, place, all); break;
    case TableKind::Temperatures: add_member_loads<TemperatureLoad>(load_case, place, all); break;
    default: add_member_loads<Misfit>(load_case, place, all); break;
    }
}

} // namespace

std::vector<Part> parts_of(const Model& model, TableKind kind)
{
    switch (kind) {
    case TableKind::Nodes: return ids<NodeId>(model.nodes);
    case TableKind::Members: return ids<MemberId>(model.members);
    case TableKind::Joints: return is_truss(model.analysis) ? std::vector<Part>() : ids<MemberId>(model.members);
    case TableKind::LoadCases: return places<LoadCasePlace>(model.load_cases);
    case TableKind::Combinations: return places<CombinationPlace>(model.combinations);
    case TableKind::Materials: return ids<MaterialId>(model.materials);
    case TableKind::Sections: return ids<SectionId>(model.sections);
    default: break;
    }
    std::vector<Part> all;
    for (std::size_t i = 0; i < model.load_cases.size(); ++i) add_loads(model.load_cases[i], i, kind, all);
    return all;
}

std::variant<DofSet, std::string> dofs_of(const CellText& entry, DofSet allowed)
{
    DofSet found;
    if (entry.is_empty()) return found;
    std::string text(entry.text);
    for (char& c : text)
        if (c == ',' || c == ';') c = ' ';
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const std::optional<Dof> dof = find_dof(word);
        if (!dof || !allowed.contains(*dof))
            return entry.manner.tr("\"{text}\" is none of {words}", {{"text", word}, {"words", names_of(allowed)}});
        found.insert(*dof);
    }
    return found;
}

} // namespace frame
