#include "femoop/methods/cross/virtual_work.h"

#include <cmath>

namespace femoop::cross {

namespace {

double moment_at(const MemberAction& action, std::size_t which, const std::vector<double>& at_end)
{
    return action.ends[which] ? at_end[action.ends[which]->index] : 0.0;
}

double rotation_at(const Problem& problem, const MemberAction& action, std::size_t which,
                   const std::vector<double>& rotation)
{
    if (!action.ends[which]) return 0.0;
    const std::optional<JointId> joint = problem[*action.ends[which]].joint;
    return joint ? rotation[joint->index] : 0.0;
}

/// Shears at a member's ends: from its end moments by its equilibrium; on a foundation by its stiffness.
Eigen::Vector2d shears(const Problem& problem, const MemberAction& action, const Moments& moments,
                       const Eigen::Vector4d& f, Eigen::Vector4d d)
{
    if (action.has_foundation) {
        d[1] = rotation_at(problem, action, 0, moments.rotation);
        d[3] = rotation_at(problem, action, 1, moments.rotation);
        const Eigen::Vector4d p = action.K * d + f;
        return {p[0], p[2]};
    }
    const double more = moment_at(action, 0, moments.at_end) + moment_at(action, 1, moments.at_end) - f[1] - f[3];
    return {f[0] + more / action.length, f[2] - more / action.length};
}

/// What moves the structure besides its members' end moments.
struct Actions {
    bool is_loaded = true;
    const std::vector<Eigen::Vector2d>& displacement;
    double scale = 1.0;
};

/// Terms that cancel but for rounding are 0 together.
class Work {
public:
    void add(double term)
    {
        sum_ += term;
        size_ += std::abs(term);
    }
    double total() const { return std::abs(sum_) <= 1e-13 * size_ ? 0.0 : sum_; }

private:
    double sum_ = 0.0, size_ = 0.0;
};

void add_members(Work& work, const Problem& problem, const Moments& moments, const Actions& actions, const Sway& sway)
{
    for (const MemberAction& action : problem.members) {
        if (action.is_overhang) continue;
        const Eigen::Vector4d mode = across(action, sway.displacement);
        const Eigen::Vector4d f = actions.is_loaded ? action.f : Eigen::Vector4d(Eigen::Vector4d::Zero());
        Eigen::Vector4d d = Eigen::Vector4d::Zero();
        if (!actions.is_loaded) d = actions.scale * across(action, actions.displacement);
        const Eigen::Vector2d V = shears(problem, action, moments, f, d);
        work.add(V[0] * mode[0]);
        work.add(V[1] * mode[2]);
        if (!actions.is_loaded) continue;
        for (int end = 0; end < 2; ++end)
            work.add(action.fx[end] *
                     action.x.dot(sway.displacement[action.nodes[static_cast<std::size_t>(end)].index]));
    }
}

void add_springs(Work& work, const Problem& problem, const Actions& actions, const Sway& sway)
{
    for (const GroundSpring& spring : problem.springs) {
        const double u = actions.scale * spring.direction.dot(actions.displacement[spring.node.index]);
        const double ground = actions.is_loaded ? spring.ground : 0.0;
        work.add(spring.stiffness * (u - ground) * spring.direction.dot(sway.displacement[spring.node.index]));
    }
}

std::vector<double> forces(const Problem& problem, const Moments& moments, const Actions& actions)
{
    std::vector<double> held;
    for (const Sway& sway : problem.sways) {
        Work work;
        add_members(work, problem, moments, actions, sway);
        add_springs(work, problem, actions, sway);
        if (actions.is_loaded)
            for (std::size_t n = 0; n < problem.node_force.size(); ++n)
                work.add(-problem.node_force[n].dot(sway.displacement[n]));
        held.push_back(work.total());
    }
    return held;
}

} // namespace

std::vector<double> holding_forces(const Problem& problem, const Moments& moments)
{
    return forces(problem, moments, {.is_loaded = true, .displacement = problem.imposed});
}

std::vector<double> holding_forces(const Problem& problem, const Moments& moments, const Sway& moved)
{
    return forces(problem, moments, {.is_loaded = false, .displacement = moved.displacement, .scale = moved.scale});
}

Eigen::Vector4d across(const MemberAction& action, const std::vector<Eigen::Vector2d>& displacement)
{
    return {action.y.dot(displacement[action.nodes[0].index]), 0.0, action.y.dot(displacement[action.nodes[1].index]),
            0.0};
}

} // namespace femoop::cross
