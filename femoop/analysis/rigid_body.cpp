#include "femoop/analysis/rigid_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "femoop/algebra/symmetric_eigen.h"
#include "femoop/analysis/node_names.h"
#include "femoop/discretisation/equations.h"

#include "femoop/element/analysis_model.h"

namespace femoop {

namespace {

using Motions = Eigen::Matrix<double, 6, 1>; ///< what each of the six motions of a body gives

/// The nodes that members join, part by part.
std::vector<std::vector<NodeId>> parts_of(const Discretisation& structure)
{
    std::vector<std::size_t> root(structure.positions.size());
    std::iota(root.begin(), root.end(), std::size_t{0});
    const auto find = [&](NodeId node) {
        std::size_t i = node.index;
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    for (const Discretisation::MemberRow& member : structure.members)
        root[find(member.nodes[1])] = find(member.nodes[0]);
    std::vector<std::vector<NodeId>> at_root(root.size()), parts;
    for (std::size_t i = 0; i < root.size(); ++i)
        if (structure.is_attached[i]) at_root[find(NodeId(i))].emplace_back(i);
    for (auto& part : at_root)
        if (!part.empty()) parts.push_back(std::move(part));
    return parts;
}

/// A part as a rigid body: how its six motions move its nodes, and which of them are held.
class RigidBody {
public:
    RigidBody(const Discretisation& structure, const std::vector<NodeId>& nodes) : structure_(structure)
    {
        for (const NodeId node : nodes) box_.extend(structure.positions[node.index]);
        for (const NodeId node : nodes) add(node);
    }

    void hold_by(MemberId member)
    {
        const MemberGeometry geometry = structure_.geometry(member);
        for (const Eigen::Vector3d& at : {geometry.start, geometry.end})
            held_ += square(along(at, geometry.axes.row(1).transpose()));
    }

    Eigen::Index n_motions() const { return rank(possible_); }
    Eigen::Index n_restraints() const { return rank(held_); }

private:
    static Eigen::Matrix<double, 6, 6> square(const Motions& motions) { return motions * motions.transpose(); }

    static Eigen::Index rank(const Eigen::Matrix<double, 6, 6>& squares)
    {
        constexpr double negligible = 1e-14; // of squares: 1e-7 of the part's size
        const Eigen::VectorXd values = symmetric_eigen(squares).values;
        return (values.array() > negligible * values.maxCoeff()).count();
    }

    /// Displacement of a point along a direction.
    Motions along(const Eigen::Vector3d& at, const Eigen::Vector3d& direction) const
    {
        Motions motions;
        motions << direction, (at - box_.center()).cross(direction) / box_.diagonal().norm();
        return motions;
    }

    Motions along(NodeId node, Dof dof, double angle) const
    {
        const auto i = static_cast<Eigen::Index>(index(dof)) % 3;
        const Eigen::Vector3d axis = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d::Unit(i);
        if (!is_rotation(dof)) return along(structure_.positions[node.index], axis);
        Motions motions;
        motions << Eigen::Vector3d::Zero(), axis;
        return motions;
    }

    void add(NodeId node)
    {
        const Discretisation::SupportRow* support = structure_.support_of(node);
        for (const Dof dof : model_dofs(structure_.kind)) {
            possible_ += square(along(node, dof, 0.0));
            const bool is_held = support != nullptr &&
                                 (support->blocked.contains(dof) || support->springs[index(dof)] > 0.0);
            if (is_held) held_ += square(along(node, dof, support->angle));
        }
    }

    const Discretisation& structure_;
    Eigen::AlignedBox3d box_;
    Eigen::Matrix<double, 6, 6> possible_ = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 6> held_ = Eigen::Matrix<double, 6, 6>::Zero();
};

bool is_on_foundation(const Discretisation& structure, MemberId member)
{
    const MemberEndConditions* end_conditions = structure.end_conditions_of(member);
    return structure.properties_of(member).xy.foundation > 0.0 &&
           (end_conditions == nullptr || !end_conditions->is_bar);
}

std::optional<Fault> lack(const RigidBody& body, const std::string& nodes, bool is_whole)
{
    const Eigen::Index n = body.n_motions(), n_restraints = body.n_restraints();
    if (n_restraints >= n) return std::nullopt;
    Fault fault{.kind = is_whole ? FaultKind::NoSupport : FaultKind::PartWithoutSupport, .arguments = {nodes}};
    if (n_restraints == 0) return fault;
    fault.kind = is_whole ? FaultKind::TooFewSupports : FaultKind::PartWithTooFewSupports;
    fault.arguments.push_back(std::to_string(n_restraints));
    fault.arguments.push_back(std::to_string(n));
    return fault;
}

} // namespace

std::vector<Fault> unheld_parts(const Model& model, const Discretisation& structure)
{
    const std::vector<std::vector<NodeId>> parts = parts_of(structure);
    std::vector<RigidBody> bodies;
    std::vector<std::size_t> body_of(structure.positions.size(), 0);
    for (const std::vector<NodeId>& part : parts) {
        for (const NodeId node : part) body_of[node.index] = bodies.size();
        bodies.emplace_back(structure, part);
    }
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        if (is_on_foundation(structure, MemberId(i)))
            bodies[body_of[structure.members[i].nodes[0].index]].hold_by(MemberId(i));
    std::vector<Fault> faults;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (auto fault = lack(bodies[i], names_of(model, parts[i]), parts.size() == 1))
            faults.push_back(std::move(*fault));
    return faults;
}

} // namespace femoop
