#include "apps/frame/document/set_library.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "femoop/edit/erase.h"
#include "femoop/edit/naming.h"
#include "femoop/model/check/check.h"

namespace frame {

using namespace femoop;

namespace {

// The member that the loads of the library act on: long enough for every place, with every property.
MemberId add_bearer(Model& library)
{
    constexpr double long_enough = 1e9;
    const MaterialId material = library.add(Material{.id = "any", .E = 1.0, .alpha = 1.0});
    Section section{.id = "any"};
    section.A = section.Iz = section.Iy = section.J = section.h = 1.0;
    Member member;
    member.id = "any";
    member.material = material;
    member.section = library.add(std::move(section));
    for (const double x : {0.0, long_enough}) {
        const NodeId node = library.add(Node{.id = fresh_node_id(library), .at = {x, 0.0, 0.0}});
        member.nodes[x > 0.0 ? 1 : 0] = node;
    }
    return library.add(std::move(member));
}

LoadCase load_case_of(const NamedSet& set, MemberId bearer, NodeId node)
{
    LoadCase load_case{.id = set.name};
    if (const auto* const load = std::get_if<MemberLoadValue>(&set.value)) load_case.members.push_back({bearer, *load});
    else load_case.nodes.push_back({node, std::get<std::vector<Component>>(set.value)});
    return load_case;
}

} // namespace

Model library_of(const std::vector<NamedSet>& sets, const Model& like)
{
    Model library;
    library.analysis = like.analysis;
    library.units = like.units;
    const auto is_load = [](const NamedSet& set) { return !std::holds_alternative<Support>(set.value); };
    for (const NamedSet& set : sets)
        if (!is_load(set))
            library.add(Node{.id = set.name, .at = {0.0, 0.0, 0.0}, .support = std::get<Support>(set.value)});
    if (std::ranges::none_of(sets, is_load)) return library;
    const MemberId bearer = add_bearer(library);
    for (const NamedSet& set : sets)
        if (is_load(set)) library.add(load_case_of(set, bearer, library[bearer].nodes[1]));
    return library;
}

std::vector<NamedSet> sets_in(const Model& library)
{
    std::vector<NamedSet> sets;
    for (const Node& node : library.nodes)
        if (node.support) sets.push_back({node.id, *node.support});
    for (const LoadCase& load_case : library.load_cases) {
        if (load_case.nodes.size() + load_case.members.size() != 1) continue;
        if (load_case.nodes.empty()) sets.push_back({load_case.id, load_case.members.front().load});
        else sets.push_back({load_case.id, load_case.nodes.front().components});
    }
    return sets;
}

namespace {

std::string entry(std::string_view list, std::size_t i) { return std::string(list) + '[' + std::to_string(i) + ']'; }

bool is_named_load(const LoadCase& load_case)
{
    const bool is_one = load_case.nodes.size() + load_case.members.size() == 1;
    return is_one && load_case.settlements.empty() && load_case.self_weight == 0.0;
}

bool is_end(const Model& library, NodeId node)
{
    return std::ranges::any_of(library.members, [&](const Member& m) { return std::ranges::count(m.nodes, node) > 0; });
}

} // namespace

std::vector<std::string> places_beyond_sets(const Model& library)
{
    std::vector<std::string> places;
    for (std::size_t i = 0; i < library.materials.size(); ++i)
        if (!is_used(library, MaterialId(i))) places.push_back(entry("materials", i));
    for (std::size_t i = 0; i < library.sections.size(); ++i)
        if (!is_used(library, SectionId(i))) places.push_back(entry("sections", i));
    for (std::size_t i = 0; i < library.nodes.size(); ++i)
        if (!library.nodes[i].support && !is_end(library, NodeId(i))) places.push_back(entry("nodes", i));
    for (std::size_t i = 0; i < library.load_cases.size(); ++i)
        if (!is_named_load(library.load_cases[i])) places.push_back(entry("load_cases", i));
    if (!library.combinations.empty()) places.emplace_back("combinations");
    if (!library.expected.empty()) places.emplace_back("expected");
    return places;
}

bool is_usable(const NamedSet& set, const Model& model)
{
    const std::vector<Fault> faults = check(library_of({set}, model));
    return std::ranges::none_of(faults, femoop::is_error);
}

} // namespace frame
