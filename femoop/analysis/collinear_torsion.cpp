#include "femoop/analysis/collinear_torsion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "femoop/element/analysis_model.h"

namespace femoop {

namespace {

constexpr double square = 1e-9; // of a unit vector: less of it is rounding

bool carries_torque(const MemberEndConditions* end_conditions)
{
    if (end_conditions == nullptr) return true;
    const auto is_joined = [&](std::size_t end) { return end_conditions->joints[end][index(LocalAxis::rx)] != 0.0; };
    return !end_conditions->is_bar && is_joined(0) && is_joined(1);
}

class ChainSearch {
public:
    ChainSearch(const Discretisation& structure, const Equations& equations, const NodeJoints& joints,
                CoupledMembers& coupled, const SparseMatrix& K)
        : structure_(structure),
          equations_(equations),
          joints_(joints),
          coupled_(coupled),
          K_(K),
          is_known_(structure.members.size(), false),
          turn_(Eigen::VectorXd::Zero(K.rows()))
    {
        list_members();
    }

    std::vector<ArtificialRestraint> run()
    {
        std::vector<ArtificialRestraint> found;
        for (std::size_t i = 0; i < structure_.members.size(); ++i) {
            if (is_known_[i] || !carries_torque(structure_.end_conditions_of(MemberId(i)))) continue;
            const Eigen::Vector3d axis = structure_.geometry(MemberId(i)).axes.row(0);
            const std::vector<NodeId> nodes = chain_from(MemberId(i), axis);
            const auto may_turn = [&](NodeId node) { return joints_.may_turn(node.index); };
            if (std::none_of(nodes.begin(), nodes.end(), may_turn)) continue;
            const std::optional<ArtificialRestraint> spin = spin_of(nodes, axis);
            if (spin && is_unrestrained(*spin) && !swings_a_member(*spin)) found.push_back(*spin);
        }
        return found;
    }

private:
    void list_members()
    {
        members_of_.resize(structure_.positions.size());
        for (std::size_t i = 0; i < structure_.members.size(); ++i)
            for (const NodeId node : structure_.members[i].nodes) members_of_[node.index].emplace_back(i);
    }

    /// All nodes that turn with the member about its axis, if any does.
    std::vector<NodeId> chain_from(MemberId first, const Eigen::Vector3d& axis)
    {
        std::vector<NodeId> nodes{structure_.members[first.index].nodes[0]};
        is_known_[first.index] = true;
        const auto take = [&](MemberId member) {
            is_known_[member.index] = true;
            for (const NodeId node : structure_.members[member.index].nodes)
                if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) nodes.push_back(node);
        };
        take(first);
        for (std::size_t next = 0; next < nodes.size(); ++next)
            for (const MemberId member : members_of_[nodes[next].index])
                if (!is_known_[member.index] && carries_torque(structure_.end_conditions_of(member)) &&
                    structure_.geometry(member).axes.row(0).transpose().cross(axis).norm() < square)
                    take(member);
        return nodes;
    }

    /// The chain's nodes turning by the same angle; nothing where a support stops one of them.
    std::optional<ArtificialRestraint> spin_of(const std::vector<NodeId>& nodes, const Eigen::Vector3d& axis) const
    {
        ArtificialRestraint spin;
        std::vector<double> direction;
        const std::span<const Dof> dofs = model_dofs(structure_.kind);
        for (const NodeId node : nodes) {
            for (std::size_t i = 0; i < dofs.size(); ++i) {
                const auto component = static_cast<Eigen::Index>(index(dofs[i])) - 3;
                if (component < 0 || std::abs(axis[component]) < square) continue;
                const std::int32_t row = equations_.of(node, i);
                if (row == Equations::none) return std::nullopt;
                spin.parts.push_back({.node = node, .dof = dofs[i], .row = row});
                direction.push_back(axis[component]);
            }
        }
        spin.direction = Eigen::Map<Eigen::VectorXd>(direction.data(), static_cast<Eigen::Index>(direction.size()));
        spin.direction.normalize();
        return spin;
    }

    /// Does nothing work against it?
    bool is_unrestrained(const ArtificialRestraint& spin)
    {
        double stiffness = 0.0;
        for (std::size_t i = 0; i < spin.parts.size(); ++i) {
            turn_[spin.parts[i].row] = spin.direction[static_cast<Eigen::Index>(i)];
            stiffness = std::max(stiffness, joints_.stiffness[spin.parts[i].node.index]);
        }
        double work = 0.0;
        for (const ArtificialRestraint::Part& part : spin.parts)
            for (SparseMatrix::InnerIterator entry(K_, part.row); entry; ++entry)
                work += (entry.row() == entry.col() ? 1.0 : 2.0) * turn_[entry.row()] * entry.value() *
                        turn_[entry.col()];
        for (const ArtificialRestraint::Part& part : spin.parts) turn_[part.row] = 0.0;
        return work <= negligible_stiffness * stiffness;
    }

    bool swings_a_member(const ArtificialRestraint& spin)
    {
        return (coupled_.motion(spin.parts) * spin.direction).norm() >= uncoupled;
    }

    const Discretisation& structure_;
    const Equations& equations_;
    const NodeJoints& joints_;
    CoupledMembers& coupled_;
    const SparseMatrix& K_;
    std::vector<std::vector<MemberId>> members_of_;
    std::vector<bool> is_known_;
    Eigen::VectorXd turn_; ///< of all unknowns; zero but while a chain is looked at
};

} // namespace

std::vector<ArtificialRestraint> collinear_torsion_mechanisms(const Discretisation& structure,
                                                              const Equations& equations, const NodeJoints& joints,
                                                              CoupledMembers& coupled, const SparseMatrix& K)
{
    if (structure.kind != AnalysisKind::Frame3d && structure.kind != AnalysisKind::Grillage) return {};
    if (std::find(joints.is_flexible.begin(), joints.is_flexible.end(), true) == joints.is_flexible.end()) return {};
    return ChainSearch(structure, equations, joints, coupled, K).run();
}

} // namespace femoop
