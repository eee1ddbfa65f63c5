#include "femoop/methods/derivation/member_alone.h"

#include <array>

#include "femoop/analysis/linear_static.h"
#include "femoop/result/components.h"

namespace femoop::derivation {

namespace {

Node held(Node node)
{
    node.support = Support{.kind = SupportKind::Fixed};
    node.mass.clear();
    return node;
}

std::vector<MemberLoad> loads_on(MemberId member, const LoadCase& load_case)
{
    std::vector<MemberLoad> loads;
    for (const MemberLoad& load : load_case.members)
        if (load.member == member) loads.push_back({MemberAlone::member, load.load});
    return loads;
}

Settlement motion_of(NodeId node, const NodeVector& displacement, AnalysisKind kind)
{
    Settlement settlement{.node = node, .components = {}};
    for (const Dof dof : dof_list(kind)) settlement.components.push_back({dof, Quantity(displacement[index(dof)])});
    return settlement;
}

} // namespace

MemberAlone take_out(const Model& model, MemberId member, const LoadCase& load_case, const CaseResult& solved)
{
    const Member& whole = model[member];
    Model alone;
    alone.analysis = model.analysis;
    alone.units = model.units;
    alone.materials = model.materials;
    alone.sections = model.sections;
    for (const NodeId node : whole.nodes) alone.add(held(model[node]));
    Member part = whole;
    part.nodes = {NodeId(0), NodeId(1)};
    alone.add(part);
    alone.add(LoadCase{.id = "loads", .self_weight = load_case.self_weight, .members = loads_on(member, load_case)});
    LoadCase moved{.id = "motion"};
    for (std::size_t end = 0; end < 2; ++end)
        moved.settlements.push_back(motion_of(NodeId(end), solved.displacement(whole.nodes[end]), model.analysis));
    alone.add(moved);
    return {analyse(alone)};
}

} // namespace femoop::derivation
