#include "femoop/analysis/settlement_force.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "femoop/element/element.h"

namespace femoop {

namespace {

/// The softest part of a structure, a rotation counted by its arm: what resists an imposed displacement of 1 at least.
double softest_part(const Discretisation& structure)
{
    const double size = structure.size(), none = std::numeric_limits<double>::infinity();
    double softest = none;
    const auto add = [&](double stiffness) {
        if (stiffness > 0.0) softest = std::min(softest, stiffness);
    };
    const auto add_joint = [&](std::size_t axis, double stiffness) {
        add(axis < 3 ? stiffness : stiffness / (size * size));
    };
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberProperties& p = structure.properties_of(MemberId(i));
        add(p.axial.EA / size);
        for (const Beam& beam : {p.xy, p.xz}) {
            add(beam.EI / std::pow(size, 3));
            add(beam.foundation * structure.geometry(MemberId(i)).length);
        }
        if (const MemberEndConditions* conditions = structure.end_conditions_of(MemberId(i)))
            for (const JointStiffness& joint : conditions->joints)
                for (std::size_t axis = 0; axis < joint.size(); ++axis) add_joint(axis, joint[axis]);
    }
    for (const Discretisation::SupportRow& support : structure.supports)
        for (const Dof dof : all_dofs) add_joint(index(dof), support.springs[index(dof)]);
    return softest < none ? softest : 0.0;
}

/// The largest displacement, a rotation as it moves the other end of the structure.
double largest_settlement(const CaseLoads& loads, double size)
{
    double largest = 0.0;
    for (const CaseLoads::OnNode& settlement : loads.settlements)
        for (const Dof dof : all_dofs)
            largest = std::max(largest, std::abs(settlement.value[index(dof)]) * (is_rotation(dof) ? size : 1.0));
    return largest;
}

/// What bodies oppose to a displacement of each node by 1, of one element at least.
std::vector<double> stiffness_of_bodies(const Discretisation& structure)
{
    std::vector<double> of_nodes(structure.positions.size(), 0.0);
    ElementMatrix K;
    for (const auto& body : structure.bodies) {
        body->stiffness(K);
        const ElementDofs dofs = body->dofs();
        const std::size_t n = dofs.of_each_node.size();
        for (std::size_t i = 0; i < dofs.n_of_nodes(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            double& of_node = of_nodes[dofs.nodes[i / n].index];
            of_node = std::max(of_node, K(row, row));
        }
    }
    return of_nodes;
}

/// Springs of curves are foundations, whose loads are their settlements.
class SprungForce {
public:
    SprungForce(const Discretisation& structure, const CaseLoads& loads, double part)
        : structure_(structure), part_(part), bodies_(stiffness_of_bodies(structure))
    {
        for (const CaseLoads::OnNode& settlement : loads.settlements)
            if (const Discretisation::SupportRow* support = structure.support_of(settlement.node))
                for (const Dof dof : all_dofs)
                    add(settlement.node, support->springs[index(dof)],
                        support->springs[index(dof)] * settlement.value[index(dof)]);
        for (const CaseLoads::OnElement& on : loads.elements) add_foundation(on);
    }

    double largest() const { return largest_; }

private:
    void add(NodeId node, double spring, double force)
    {
        if (spring > 0.0)
            largest_ = std::max(largest_, std::abs(force) * std::min(1.0, part_ * bodies_[node.index] / spring));
    }

    void add_foundation(const CaseLoads::OnElement& on)
    {
        const std::size_t first = structure_.members.size() + structure_.bodies.size();
        if (on.element < first) return;
        const Element& foundation = *structure_.foundations[on.element - first];
        ElementVector f;
        foundation.equivalent_forces(on.loads(), f);
        ElementMatrix K;
        foundation.stiffness(K);
        const ElementDofs dofs = foundation.dofs();
        for (std::size_t i = 0; i < dofs.n_of_nodes(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            add(dofs.nodes[i / dofs.of_each_node.size()], K(row, row), f[row]);
        }
    }

    const Discretisation& structure_;
    double part_;
    std::vector<double> bodies_;
    double largest_ = 0.0;
};

bool has_sprung_settlements(const Discretisation& structure, const CaseLoads& loads)
{
    const std::size_t first = structure.members.size() + structure.bodies.size();
    const auto is_sprung = [&structure](const CaseLoads::OnNode& settlement) {
        const Discretisation::SupportRow* support = structure.support_of(settlement.node);
        return support != nullptr && std::ranges::any_of(support->springs, [](double k) { return k > 0.0; });
    };
    return std::ranges::any_of(loads.settlements, is_sprung) ||
           std::ranges::any_of(loads.elements, [first](const auto& on) { return on.element >= first; });
}

} // namespace

double sprung_force(const Discretisation& structure, const CaseLoads& loads, double part)
{
    return has_sprung_settlements(structure, loads) ? SprungForce(structure, loads, part).largest() : 0.0;
}

double settlement_force(const Discretisation& structure, const CaseLoads& loads)
{
    return softest_part(structure) * largest_settlement(loads, structure.size());
}

} // namespace femoop
