#include "femoop/discretisation/case_loads.h"

#include <utility>

#include "femoop/load/span_loads.h"

namespace femoop {

namespace {

/// The span loads of one load case, member by member.
class SpanLoadTable {
public:
    explicit SpanLoadTable(const Discretisation& structure) : structure_(structure) {}

    void add(const MemberLoad& load)
    {
        const MemberId member = load.member;
        append(member, span_loads(load, structure_.geometry(member), structure_.properties_of(member)));
    }

    void add_self_weight(double factor)
    {
        for (std::size_t i = 0; i < structure_.members.size(); ++i) {
            const MemberId member(i);
            const MemberProperties& properties = structure_.properties_of(member);
            const MemberEndConditions* end_conditions = structure_.end_conditions_of(member);
            const bool is_rigid = end_conditions != nullptr && end_conditions->constraint == Constraint::Rigid;
            if (properties.weight == 0.0 || is_rigid) continue;
            append(member, self_weight(factor, structure_.kind, structure_.geometry(member), properties));
        }
    }

    /// Sorts what was added by member.
    void move_into(CaseLoads& loads)
    {
        if (loads_.empty()) return;
        loads.first.assign(structure_.members.size() + 1, 0);
        for (const auto& [member, load] : loads_) ++loads.first[member.index + 1];
        for (std::size_t i = 0; i < structure_.members.size(); ++i) loads.first[i + 1] += loads.first[i];
        loads.span_loads.resize(loads_.size());
        std::vector<std::uint32_t> next(loads.first.begin(), loads.first.end() - 1);
        for (const auto& [member, load] : loads_) loads.span_loads[next[member.index]++] = load;
    }

private:
    void append(MemberId member, const std::vector<SpanLoad>& loads)
    {
        for (const SpanLoad& load : loads) loads_.emplace_back(member, load);
    }

    const Discretisation& structure_;
    std::vector<std::pair<MemberId, SpanLoad>> loads_;
};

CaseLoads::OnNode on_node(NodeId node, const std::vector<Component>& components)
{
    CaseLoads::OnNode row{.node = node};
    for (const Component& component : components) row.value[index(component.dof)] += component.value;
    return row;
}

} // namespace

std::vector<CaseLoads> loads_of(const Model& model, const Discretisation& structure)
{
    std::vector<CaseLoads> all;
    for (const LoadCase& load_case : model.load_cases) {
        CaseLoads loads;
        for (const NodeLoad& load : load_case.nodes) loads.nodes.push_back(on_node(load.node, load.components));
        for (const Settlement& s : load_case.settlements) loads.settlements.push_back(on_node(s.node, s.components));
        SpanLoadTable table(structure);
        for (const MemberLoad& load : load_case.members) table.add(load);
        if (load_case.self_weight != 0.0) table.add_self_weight(load_case.self_weight);
        table.move_into(loads);
        all.push_back(std::move(loads));
    }
    return all;
}

} // namespace femoop
