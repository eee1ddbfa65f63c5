#include "apps/frame/document/document.h"

#include "femoop/model/memory_footprint.h"
#include "femoop/typical/steel.h"

namespace frame {

using namespace femoop;

namespace {

Member joined(std::string id, NodeId first, NodeId second, SectionId section)
{
    Member member;
    member.id = std::move(id);
    member.nodes = {first, second};
    member.material = MaterialId(0);
    member.section = section;
    return member;
}

Section with_properties(std::string id, Quantity A, Quantity Iz)
{
    Section section;
    section.id = std::move(id);
    section.A = std::move(A);
    section.Iz = std::move(Iz);
    return section;
}

Node at(std::string id, double x, double y, std::optional<Support> support = std::nullopt)
{
    Node node;
    node.id = std::move(id);
    node.at = {x, y, 0.0};
    node.support = std::move(support);
    return node;
}

} // namespace

Document starting_document()
{
    Model model;
    model.title = "Portal";
    model.add(steel(model.units, "205 GPa"));
    const SectionId column = model.add(with_properties("column", Quantity(0.012), Quantity(2.0e-4)));
    const SectionId beam = model.add(with_properties("beam", Quantity(0.008), Quantity(3.0e-4)));
    Support fixed;
    fixed.kind = SupportKind::Fixed;
    const NodeId A = model.add(at("A", 0.0, 0.0, fixed));
    const NodeId B = model.add(at("B", 0.0, 4.0));
    const NodeId C = model.add(at("C", 6.0, 4.0));
    const NodeId D = model.add(at("D", 6.0, 0.0, fixed));
    model.add(joined("AB", A, B, column));
    const MemberId BC = model.add(joined("BC", B, C, beam));
    model.add(joined("CD", C, D, column));
    LoadCase load_case;
    load_case.id = "G";
    load_case.nodes.push_back({B, {{Dof::ux, Quantity(10.0)}}});
    load_case.members.push_back({BC, DistributedLoad{.values = {{Dof::uy, Quantity(-20.0), std::nullopt}},
                                                     .from = std::nullopt,
                                                     .to = std::nullopt}});
    model.add(std::move(load_case));
    return {std::move(model)};
}

std::size_t memory_footprint(const Document& document)
{
    const Companion& companion = document.companion;
    std::size_t bytes = femoop::memory_footprint(document.model) + companion.sets.size() * sizeof(NamedSet) +
                        companion.views.size() * sizeof(NamedView);
    for (const DimensionLine& line : companion.dimensions)
        bytes += sizeof(DimensionLine) + line.nodes.size() * sizeof(std::string);
    return bytes;
}

} // namespace frame
