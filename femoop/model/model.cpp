#include "femoop/model/model.h"

#include "femoop/model/memory_footprint.h"

#include <stdexcept>
#include <utility>

namespace femoop {

namespace {

template <class Identifier, class List> std::optional<Identifier> find(const List& list, std::string_view id)
{
    for (std::size_t i = 0; i < list.size(); ++i)
        if (list[i].id == id) return Identifier(i);
    return std::nullopt;
}

template <class Identifier, class List, class Item> Identifier append(List& list, Item&& item)
{
    list.push_back(std::forward<Item>(item));
    return Identifier(list.size() - 1);
}

} // namespace

MaterialId Model::add(Material material) { return append<MaterialId>(materials, std::move(material)); }
SectionId Model::add(Section section) { return append<SectionId>(sections, std::move(section)); }
NodeId Model::add(Node node) { return append<NodeId>(nodes, std::move(node)); }
MemberId Model::add(Member member) { return append<MemberId>(members, std::move(member)); }

CaseId Model::add(LoadCase load_case)
{
    if (!combinations.empty())
        throw std::logic_error("Model::add(LoadCase): add load cases before combinations, whose ids follow them");
    return append<CaseId>(load_cases, std::move(load_case));
}

const std::string& Model::case_name(CaseId id) const
{
    return id.index < load_cases.size() ? load_cases[id.index].id : combinations.at(id.index - load_cases.size()).id;
}

std::optional<NodeId> Model::find_node(std::string_view id) const { return find<NodeId>(nodes, id); }
std::optional<MemberId> Model::find_member(std::string_view id) const { return find<MemberId>(members, id); }

std::optional<CaseId> Model::find_case(std::string_view id) const
{
    if (const auto found = find<CaseId>(load_cases, id)) return found;
    if (const auto found = find<CaseId>(combinations, id)) return CaseId(load_cases.size() + found->index);
    return std::nullopt;
}

namespace {

constexpr std::size_t typed_text = 64; // of one quantity, with its allocation

std::size_t footprint(const LoadCase& load_case)
{
    const std::size_t one_component = sizeof(Component) + typed_text;
    return sizeof(LoadCase) + load_case.nodes.size() * (sizeof(NodeLoad) + one_component) +
           load_case.settlements.size() * (sizeof(Settlement) + one_component) +
           load_case.members.size() * (sizeof(MemberLoad) + sizeof(DistributedLoad::Value) + typed_text);
}

} // namespace

std::size_t memory_footprint(const Model& model)
{
    std::size_t bytes = sizeof(Model) + model.title.size() + model.notes.size() +
                        model.nodes.size() * (sizeof(Node) + 2 * typed_text) + model.members.size() * sizeof(Member) +
                        model.materials.size() * (sizeof(Material) + 4 * typed_text) +
                        model.sections.size() * (sizeof(Section) + 4 * typed_text) +
                        model.expected.size() * sizeof(Expected);
    for (const LoadCase& load_case : model.load_cases) bytes += footprint(load_case);
    for (const Combination& combination : model.combinations)
        bytes += sizeof(Combination) + combination.terms.size() * sizeof(Combination::Term);
    for (const ExtraBlock& block : model.extra) bytes += sizeof(ExtraBlock) + block.json.size();
    return bytes;
}

} // namespace femoop
