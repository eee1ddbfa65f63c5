#include "femoop/methods/cross/prop_forces.h"

#include <algorithm>
#include <cmath>

#include "femoop/methods/cross/slope_deflection.h"
#include "femoop/methods/cross/virtual_work.h"

namespace femoop::cross {

namespace {

constexpr double rounding = 1e-10; // of the terms that a force adds up

std::vector<double> held(const Problem& problem, const Sheet& sheet, std::size_t stage)
{
    const Moments moments{sheet.end.moments, sheet.end.rotations};
    return stage == 0 ? holding_forces(problem, moments) : holding_forces(problem, moments, problem.sways[stage - 1]);
}

/// Largest force that a sheet leaves where each end moment is off by so much.
double force_of(const Problem& problem, const Sway& sway, double moment)
{
    double force = 0.0;
    for (std::size_t m = 0; m < problem.members.size(); ++m)
        for (const auto& end : problem.members[m].ends)
            if (end && !problem.members[m].is_overhang) force += std::abs(sway.chord_rotation[m]) * moment;
    return force;
}

} // namespace

std::vector<double> PropForces::at_end_of(const Sheet& sheet, std::size_t stage)
{
    std::vector<double> forces = held(problem_, sheet, stage);
    const auto may_vanish = [&](std::size_t k) {
        return forces[k] != 0.0 && std::abs(forces[k]) <= force_of(problem_, problem_.sways[k], sheet.tolerance);
    };
    std::vector<std::size_t> doubtful;
    for (std::size_t k = 0; k < forces.size() && sheet.is_balanced; ++k)
        if (may_vanish(k)) doubtful.push_back(k);
    if (doubtful.empty() || problem_.joints.empty()) return forces;
    const std::vector<bool> is_nothing = vanish_in_limit(stage);
    for (const std::size_t k : doubtful)
        if (is_nothing[k]) forces[k] = 0.0;
    return forces;
}

std::vector<bool> PropForces::vanish_in_limit(std::size_t stage)
{
    const auto n = static_cast<Eigen::Index>(problem_.joints.size()),
               n_sways = static_cast<Eigen::Index>(problem_.sways.size());
    if (!equations_) {
        const SlopeDeflection system = equations_of(problem_);
        equations_ = Equations{system.A, system.b, system.A.topLeftCorner(n, n).ldlt()};
    }
    const Eigen::MatrixXd& A = equations_->A;
    Eigen::VectorXd loads = equations_->b;
    if (stage > 0) loads = -problem_.sways[stage - 1].scale * A.col(n + static_cast<Eigen::Index>(stage - 1));
    const Eigen::VectorXd turned = equations_->of_joints.solve(loads.head(n));
    const auto of_turns = A.bottomLeftCorner(n_sways, n);
    const Eigen::VectorXd forces = of_turns * turned - loads.tail(n_sways);
    const Eigen::VectorXd sizes = of_turns.cwiseAbs() * turned.cwiseAbs() + loads.tail(n_sways).cwiseAbs();
    std::vector<bool> vanish;
    for (Eigen::Index k = 0; k < n_sways; ++k) vanish.push_back(std::abs(forces[k]) <= rounding * sizes[k]);
    return vanish;
}

} // namespace femoop::cross
