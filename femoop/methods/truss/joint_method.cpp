#include "femoop/methods/truss/joint_method.h"

#include <Eigen/LU>
#include <algorithm>
#include <tuple>

namespace femoop::truss {

namespace {

constexpr std::optional<double> not_known;

class JointByJoint {
public:
    JointByJoint(const Truss& truss, const Arrangement& arrangement)
        : truss_(truss), arrangement_(arrangement), known_(truss.bars.size()), is_done_(truss.joints.size(), false)
    {
        for (std::size_t i = 0; i < truss.joints.size(); ++i)
            if (!truss.bars_at[i].empty()) order_.emplace_back(i);
        std::ranges::sort(order_, {}, [&](NodeId joint) {
            return std::tuple(truss.joints[joint.index].x(), truss.joints[joint.index].y());
        });
    }

    JointMethod worked() &&
    {
        while (std::ranges::find(known_, not_known) != known_.end()) {
            if (const auto joint = next()) solve(*joint);
            else find_elsewhere();
        }
        for (const NodeId joint : order_)
            if (!is_done_[joint.index]) method_.steps.push_back(closed(joint, StepKind::Check, {}));
        for (const std::optional<double>& force : known_) method_.forces.push_back(*force);
        return std::move(method_);
    }

private:
    std::vector<MemberId> unknown_at(NodeId joint) const
    {
        std::vector<MemberId> unknown;
        for (const Spoke& spoke : arrangement_[joint.index])
            if (spoke.bar && !known_[spoke.bar->index]) unknown.push_back(*spoke.bar);
        return unknown;
    }

    std::optional<NodeId> next() const
    {
        const auto found = std::ranges::find_if(order_, [&](NodeId joint) {
            const std::vector<MemberId> unknown = unknown_at(joint);
            if (unknown.size() == 2)
                return !truss_.are_parallel(truss_[unknown[0]].direction, truss_[unknown[1]].direction);
            return unknown.size() == 1;
        });
        return found == order_.end() ? std::nullopt : std::optional(*found);
    }

    Eigen::Vector2d known_sum(NodeId joint) const
    {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const Spoke& spoke : arrangement_[joint.index]) {
            if (spoke.force) sum += truss_.forces[*spoke.force].force;
            if (spoke.bar && known_[spoke.bar->index]) sum += *known_[spoke.bar->index] * spoke.away;
        }
        return sum;
    }

    void solve(NodeId joint)
    {
        const std::vector<MemberId> unknown = unknown_at(joint);
        const Eigen::Vector2d sum = known_sum(joint), first = truss_.away_from(joint, unknown[0]);
        if (unknown.size() == 1) {
            learn(unknown[0], -sum.dot(first));
        } else {
            Eigen::Matrix2d directions;
            directions << first, truss_.away_from(joint, unknown[1]);
            const Eigen::Vector2d forces = directions.inverse() * -sum;
            learn(unknown[0], forces[0]);
            learn(unknown[1], forces[1]);
        }
        is_done_[joint.index] = true;
        method_.steps.push_back(closed(joint, StepKind::Joint, unknown));
    }

    void find_elsewhere()
    {
        if (auto cut = cut_through_unknown(truss_, known_)) {
            const CutEquation& equation = cut->equations.front();
            learn(equation.bar, equation.force);
            method_.steps.push_back(
                {.kind = StepKind::Cut, .joint = {}, .forces = {}, .found = {equation.bar}, .cut = std::move(cut)});
            return;
        }
        const auto first = std::ranges::find(known_, not_known);
        const MemberId bar(static_cast<std::size_t>(first - known_.begin()));
        learn(bar, truss_[bar].force);
        method_.steps.push_back({.kind = StepKind::Analysis, .joint = {}, .forces = {}, .found = {bar}, .cut = {}});
    }

    void learn(MemberId bar, double force) { known_[bar.index] = truss_.is_zero(force) ? 0.0 : force; }

    Step closed(NodeId joint, StepKind kind, const std::vector<MemberId>& found) const
    {
        Step step{.kind = kind, .joint = joint, .forces = {}, .found = found, .cut = {}};
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const Spoke& spoke : arrangement_[joint.index]) {
            JointForce side{.bar = spoke.bar, .force = spoke.force, .away = spoke.away, .on_joint = {}};
            side.value = spoke.bar ? *known_[spoke.bar->index] : truss_.forces[*spoke.force].force.norm();
            side.on_joint = spoke.bar ? Eigen::Vector2d(side.value * spoke.away) : truss_.forces[*spoke.force].force;
            side.is_found = spoke.bar && std::ranges::find(found, *spoke.bar) != found.end();
            sum += side.on_joint;
            step.forces.push_back(side);
        }
        step.closing_error = sum.norm();
        return step;
    }

    const Truss& truss_;
    const Arrangement& arrangement_;
    KnownForces known_;
    std::vector<bool> is_done_;
    std::vector<NodeId> order_;
    JointMethod method_;
};

} // namespace

JointMethod joint_method(const Truss& truss, const Arrangement& arrangement)
{
    return JointByJoint(truss, arrangement).worked();
}

} // namespace femoop::truss
