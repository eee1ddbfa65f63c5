#include "femoop/methods/cross/overhang.h"

#include <algorithm>
#include <cstddef>

namespace femoop::cross {

namespace {

class Pruning {
public:
    Pruning(const Discretisation& structure, std::vector<LoadedMember>& members, CaseForces& forces)
        : structure_(structure),
          members_(members),
          forces_(forces),
          moment_(forces.node_moment),
          members_at_(structure.positions.size())
    {
        overhangs_.is_tip.assign(structure.positions.size(), false);
        for (std::size_t i = 0; i < members.size(); ++i)
            for (const NodeId node : members[i].action.nodes) members_at_[node.index].push_back(i);
    }

    Overhangs run()
    {
        std::vector<NodeId> candidates;
        for (std::size_t i = 0; i < members_at_.size(); ++i) candidates.emplace_back(i);
        while (!candidates.empty()) {
            const NodeId tip = candidates.back();
            candidates.pop_back();
            if (is_tip(tip)) candidates.push_back(take_off(tip));
        }
        return std::move(overhangs_);
    }

private:
    bool is_tip(NodeId node) const
    {
        if (members_at_[node.index].size() != 1 || is_held(node)) return false;
        return members_[members_at_[node.index].front()].can_overhang;
    }

    bool is_held(NodeId node) const
    {
        const Discretisation::SupportRow* support = structure_.support_of(node);
        if (support == nullptr) return false;
        const auto is_spring = [](double stiffness) { return stiffness > 0.0; };
        return !support->blocked.is_empty() || std::ranges::any_of(support->springs, is_spring);
    }

    /// \returns the node that the member of this tip hangs on
    NodeId take_off(NodeId tip)
    {
        const std::size_t i = members_at_[tip.index].front();
        MemberAction& action = members_[i].action;
        const std::size_t end = action.nodes[0] == tip ? 0 : 1;
        const NodeId root = action.nodes[1 - end];
        overhangs_.is_tip[tip.index] = true;
        action.is_overhang = true;
        overhangs_.parts.push_back({root, tip, action.x});
        move_forces(action, end);
        members_at_[tip.index].clear();
        std::erase(members_at_[root.index], i);
        return root;
    }

    /// What acts on the tip and along the member goes to its root.
    void move_forces(MemberAction& action, std::size_t end)
    {
        const NodeId tip = action.nodes[end], root = action.nodes[1 - end];
        const auto e = static_cast<int>(end), r = 1 - e;
        const Eigen::Vector2d at_tip = forces_.node_force[tip.index] - action.y * action.f[2 * e] -
                                       action.x * action.fx[e];
        const double arm = end == 1 ? action.length : -action.length;
        const double moment = moment_[tip.index] - action.f[2 * e + 1] + arm * action.y.dot(at_tip) -
                              action.f[2 * r + 1];
        forces_.node_force[root.index] += at_tip - action.y * action.f[2 * r] - action.x * action.fx[r];
        forces_.node_force[tip.index].setZero();
        action.f.setZero();
        action.fx.setZero();
        action.f[2 * e + 1] = moment_[tip.index];
        action.f[2 * r + 1] = -moment;
        action.K.setZero();
        moment_[root.index] += moment;
    }

    const Discretisation& structure_;
    std::vector<LoadedMember>& members_;
    CaseForces& forces_;
    std::vector<double> moment_; ///< at every node, with those of the overhangs
    std::vector<std::vector<std::size_t>> members_at_;
    Overhangs overhangs_;
};

} // namespace

Overhangs take_off_overhangs(const Discretisation& structure, std::vector<LoadedMember>& members, CaseForces& forces)
{
    return Pruning(structure, members, forces).run();
}

void carry_over_load(const Overhangs& overhangs, std::vector<Eigen::Vector2d>& displacement)
{
    constexpr double aslant = 1e-9;
    for (auto part = overhangs.parts.rbegin(); part != overhangs.parts.rend(); ++part)
        if (part->axis.cwiseAbs().minCoeff() < aslant)
            displacement[part->tip.index] = part->axis.dot(displacement[part->root.index]) * part->axis;
}

} // namespace femoop::cross
