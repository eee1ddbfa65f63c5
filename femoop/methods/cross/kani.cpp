#include "femoop/methods/cross/kani.h"

#include <algorithm>
#include <cmath>

#include "femoop/methods/cross/slope_deflection.h"

namespace femoop::cross {

namespace {

/// Joint after joint, sway after sway: each equation is solved for its own unknown.
void improve(const SlopeDeflection& system, Eigen::VectorXd& x)
{
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += (system.b[i] - system.A.row(i).dot(x)) / system.A(i, i);
}

KaniCycle cycle_of(const Problem& problem, const Eigen::VectorXd& x)
{
    const std::size_t n = problem.joints.size();
    KaniCycle cycle;
    for (std::size_t e = 0; e < problem.ends.size(); ++e) {
        const End& end = problem.ends[e];
        cycle.rotation_contribution.push_back(end.joint ? 0.5 * end.stiffness * x[end.joint->index] : 0.0);
        double sway = 0.0;
        for (std::size_t s = 0; s < problem.sways.size(); ++s)
            sway += problem.sways[s].loading.fixed_end[e] / problem.sways[s].scale *
                    x[static_cast<Eigen::Index>(n + s)];
        cycle.sway_contribution.push_back(sway);
    }
    return cycle;
}

double largest_change(const KaniCycle& before, const KaniCycle& after)
{
    double largest = 0.0;
    for (std::size_t e = 0; e < after.rotation_contribution.size(); ++e)
        largest = std::max({largest, std::abs(after.rotation_contribution[e] - before.rotation_contribution[e]),
                            std::abs(after.sway_contribution[e] - before.sway_contribution[e])});
    return largest;
}

} // namespace

Kani kani(const Model& model, const Problem& problem, const KaniOptions& options)
{
    const SlopeDeflection system = equations_of(problem);
    if (system.b.size() > 0 && !(system.A.diagonal().minCoeff() > 0.0)) refuse_mechanism(model);
    Kani result;
    for (const End& end : problem.ends) result.rotation_factor.push_back(end.joint ? -0.5 * end.factor : 0.0);
    double largest = 0.0;
    for (const double moment : problem.loading.fixed_end) largest = std::max(largest, std::abs(moment));

    Eigen::VectorXd x = Eigen::VectorXd::Zero(system.b.size());
    KaniCycle before = cycle_of(problem, x);
    while (!result.is_converged && result.cycles.size() < options.most_cycles) {
        improve(system, x);
        KaniCycle cycle = cycle_of(problem, x);
        cycle.largest_change = largest_change(before, cycle);
        for (const double moment : cycle.sway_contribution) largest = std::max(largest, std::abs(moment));
        result.is_converged = cycle.largest_change <= options.tolerance * largest;
        before = cycle;
        result.cycles.push_back(std::move(cycle));
    }
    result.moments = end_moments(problem, x);
    return result;
}

} // namespace femoop::cross
