#include "femoop/methods/cross/props.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/algebra/dense_solution.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/methods/cross/kinematics.h"
#include "femoop/methods/cross/state_model.h"
#include "femoop/methods/cross/virtual_work.h"

namespace femoop::cross {

namespace {

constexpr double no_prop_motion = 1e-9;         // of a node, where the sway's prop moves by 1
constexpr double rest_of_modes = 1e-13;         // of the largest: what combining modes leaves
constexpr double largest_of_sway_sheet = 100.0; // the largest fixed-end moment of a sway's sheet

/// How far each sway moves each prop along its direction.
Eigen::MatrixXd prop_motions(const Problem& problem, const std::vector<Prop>& props)
{
    Eigen::MatrixXd D(props.size(), problem.sways.size());
    for (std::size_t j = 0; j < props.size(); ++j)
        for (std::size_t k = 0; k < problem.sways.size(); ++k)
            D(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) = props[j].direction.dot(
                problem.sways[k].displacement[props[j].node.index]);
    return D;
}

void without_rests(std::vector<double>& values)
{
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    for (double& value : values)
        if (std::abs(value) < rest_of_modes * largest) value = 0.0;
}

/// So much of every sway.
Sway combined_sway(const Problem& problem, const Eigen::VectorXd& shares, const Prop& prop)
{
    Sway sum{.prop = prop.node, .direction = prop.direction, .displacement = {}, .chord_rotation = {}, .loading = {}};
    sum.displacement.assign(problem.sways.front().displacement.size(), Eigen::Vector2d::Zero());
    sum.chord_rotation.assign(problem.members.size(), 0.0);
    sum.loading.fixed_end.assign(problem.ends.size(), 0.0);
    sum.loading.joint_load.assign(problem.joints.size(), 0.0);
    for (std::size_t k = 0; k < problem.sways.size(); ++k) {
        const Sway& sway = problem.sways[k];
        const double share = shares[static_cast<Eigen::Index>(k)];
        for (std::size_t n = 0; n < sum.displacement.size(); ++n) sum.displacement[n] += share * sway.displacement[n];
        for (std::size_t m = 0; m < sum.chord_rotation.size(); ++m)
            sum.chord_rotation[m] += share * sway.chord_rotation[m];
        for (std::size_t e = 0; e < sum.loading.fixed_end.size(); ++e)
            sum.loading.fixed_end[e] += share / sway.scale * sway.loading.fixed_end[e];
    }
    without_rests(sum.chord_rotation);
    without_rests(sum.loading.fixed_end);
    return sum;
}

void scale_to_nice(Sway& sway)
{
    double largest = 0.0;
    for (const double moment : sway.loading.fixed_end) largest = std::max(largest, std::abs(moment));
    sway.scale = largest > 0.0 ? largest_of_sway_sheet / largest : 1.0;
    for (double& moment : sway.loading.fixed_end) moment *= sway.scale;
}

/// What settlements and heat impose moves on with the sways, so that the new props stay.
void hold_imposed(Problem& problem, const std::vector<Prop>& props)
{
    const std::vector<Eigen::Vector2d> before = problem.imposed;
    for (std::size_t k = 0; k < props.size(); ++k) {
        const double gone = props[k].direction.dot(before[props[k].node.index]);
        if (gone == 0.0) continue;
        for (std::size_t n = 0; n < before.size(); ++n) problem.imposed[n] -= gone * problem.sways[k].displacement[n];
    }
    for (MemberAction& action : problem.members) {
        if (action.is_overhang) continue;
        action.f += action.K * (across(action, problem.imposed) - across(action, before));
        for (std::size_t which = 0; which < 2; ++which)
            if (action.ends[which])
                problem.loading.fixed_end[action.ends[which]->index] =
                    action.f[static_cast<Eigen::Index>(2 * which + 1)];
    }
}

/// The structure alone, with a unit force at each prop, each in a load case of its own.
Model with_unit_forces(const Model& model, const Problem& problem)
{
    Model loaded = model;
    loaded.load_cases.clear();
    loaded.combinations.clear();
    loaded.expected.clear();
    loaded.extra.clear();
    for (std::size_t k = 0; k < problem.sways.size(); ++k) {
        const Sway& sway = problem.sways[k];
        LoadCase load_case{.id = std::to_string(k)};
        load_case.nodes.push_back(
            {.node = sway.prop, .components = {{Dof::ux, sway.direction.x()}, {Dof::uy, sway.direction.y()}}});
        loaded.load_cases.push_back(std::move(load_case));
    }
    return loaded;
}

double displacement_at(const Sway& sway, const CaseResult& result)
{
    const NodeVector u = result.displacement(sway.prop);
    return sway.direction.x() * u[index(Dof::ux)] + sway.direction.y() * u[index(Dof::uy)];
}

} // namespace

std::array<Eigen::Vector2d, 2> prop_axes(const Model& model, NodeId node)
{
    const Eigen::Matrix2d axes = support_axes(discretise(model), node);
    return {axes.row(0).transpose(), axes.row(1).transpose()};
}

bool moves(const Problem& problem, const Prop& prop)
{
    return std::ranges::any_of(problem.sways, [&](const Sway& sway) {
        return std::abs(prop.direction.dot(sway.displacement[prop.node.index])) > no_prop_motion;
    });
}

bool hold_apart(const Problem& problem, const std::vector<Prop>& props)
{
    Eigen::FullPivLU<Eigen::MatrixXd> motion(prop_motions(problem, props));
    motion.setThreshold(no_prop_motion);
    return motion.rank() == static_cast<Eigen::Index>(props.size());
}

std::optional<Problem> propped_at(const Problem& problem, const std::vector<Prop>& props)
{
    if (props.size() != problem.sways.size()) return std::nullopt;
    if (props.empty()) return problem;
    if (!hold_apart(problem, props)) return std::nullopt;
    const Eigen::MatrixXd shares = dense_inverse(prop_motions(problem, props));
    Problem moved = problem;
    for (std::size_t k = 0; k < props.size(); ++k)
        moved.sways[k] = combined_sway(problem, shares.col(static_cast<Eigen::Index>(k)), props[k]);
    hold_imposed(moved, props);
    for (Sway& sway : moved.sways) scale_to_nice(sway);
    return moved;
}

ProppedStructure::ProppedStructure(const Model& model, const Problem& problem)
{
    const auto n = static_cast<Eigen::Index>(problem.sways.size());
    const Results results = analyse(model);
    const CaseResult free = results[problem.load_case];
    free_ = {.moments = end_moments(model, problem, free), .forces = std::vector<double>(problem.sways.size(), 0.0)};
    gone_.resize(n);
    flexibility_.resize(n, n);
    const Model unit_model = with_unit_forces(model, problem);
    const Results units = analyse(unit_model);
    Problem unloaded = problem;
    std::ranges::fill(unloaded.loading.fixed_end, 0.0);
    for (Eigen::Index k = 0; k < n; ++k) {
        unloaded.load_case = CaseId(static_cast<std::size_t>(k));
        const CaseResult unit = units[unloaded.load_case];
        unit_.push_back(end_moments(unit_model, unloaded, unit));
        gone_[k] = displacement_at(problem.sways[static_cast<std::size_t>(k)], free);
        for (Eigen::Index j = 0; j < n; ++j)
            flexibility_(j, k) = displacement_at(problem.sways[static_cast<std::size_t>(j)], unit);
    }
}

PropState ProppedStructure::with_forces(const Eigen::VectorXd& forces) const
{
    PropState state{.moments = std::vector<double>(free_.moments.size(), 0.0),
                    .forces = {forces.data(), forces.data() + forces.size()}};
    for (std::size_t k = 0; k < unit_.size(); ++k)
        for (std::size_t e = 0; e < state.moments.size(); ++e)
            state.moments[e] += forces[static_cast<Eigen::Index>(k)] * unit_[k][e];
    return state;
}

PropState ProppedStructure::loaded() const
{
    if (unit_.empty()) return free_;
    PropState state = with_forces(-flexibility_.fullPivLu().solve(gone_));
    for (std::size_t e = 0; e < state.moments.size(); ++e) state.moments[e] += free_.moments[e];
    return state;
}

PropState ProppedStructure::moved(std::size_t k, double by) const
{
    const Eigen::VectorXd moved = by * Eigen::VectorXd::Unit(gone_.size(), static_cast<Eigen::Index>(k));
    return with_forces(flexibility_.fullPivLu().solve(moved));
}

} // namespace femoop::cross
