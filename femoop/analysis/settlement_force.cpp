#include "femoop/analysis/settlement_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

} // namespace

double settlement_force(const Discretisation& structure, const CaseLoads& loads)
{
    return softest_part(structure) * largest_settlement(loads, structure.size());
}

} // namespace femoop
