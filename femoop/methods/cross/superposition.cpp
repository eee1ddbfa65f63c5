#include "femoop/methods/cross/superposition.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "femoop/methods/cross/prop_forces.h"
#include "femoop/methods/cross/slope_deflection.h"

namespace femoop::cross {

namespace {

constexpr double no_scaled_pivot = 1e-9; // of the scaled equations

Stage held_stage(const Model& model, const Problem& problem, const Procedure& procedure, PropForces& forces)
{
    Stage stage{.sheet = distribute(model, problem.of_sheet(0), problem.loading, procedure), .holding = {}};
    stage.holding = forces.at_end_of(stage.sheet, 0);
    return stage;
}

Stage sway_stage(const Model& model, const Problem& problem, std::size_t k, const Procedure& procedure,
                 PropForces& forces)
{
    const Sway& sway = problem.sways[k];
    Stage stage{.sheet = distribute(model, problem.of_sheet(k + 1), sway.loading, procedure), .holding = {}};
    stage.holding = forces.at_end_of(stage.sheet, k + 1);
    return stage;
}

void solve(const Model& model, Superposition& all)
{
    const auto n = static_cast<Eigen::Index>(all.sways.size());
    all.R.resize(n, n);
    all.r.resize(n);
    for (Eigen::Index j = 0; j < n; ++j) {
        all.r[j] = 0.0 - all.held.holding[static_cast<std::size_t>(j)];
        for (Eigen::Index k = 0; k < n; ++k)
            all.R(j, k) = all.sways[static_cast<std::size_t>(k)].holding[static_cast<std::size_t>(j)];
    }
    if (n == 0) return;
    const Eigen::VectorXd rows = all.R.cwiseAbs().rowwise().maxCoeff();
    if (!(rows.minCoeff() > 0.0)) refuse_mechanism(model);
    Eigen::FullPivLU<Eigen::MatrixXd> factored(rows.cwiseInverse().asDiagonal() * all.R);
    factored.setThreshold(no_scaled_pivot);
    if (!factored.isInvertible()) refuse_mechanism(model);
    all.x = factored.solve(rows.cwiseInverse().asDiagonal() * all.r);
    all.x.array() += 0.0; // no minus zero
}

/// The tolerance of the sways' sheets for which all that is added of them is as exact as the sheet of the loads.
double fitting_tolerance(const Superposition& all)
{
    return all.held.sheet.tolerance / std::max(1.0, all.x.cwiseAbs().sum());
}

void add_up(const Problem& problem, Superposition& all)
{
    all.moments = all.held.sheet.end.moments;
    all.rotations = all.held.sheet.end.rotations;
    for (std::size_t k = 0; k < all.sways.size(); ++k) {
        const double x = all.x[static_cast<Eigen::Index>(k)];
        const State& state = all.sways[k].sheet.end;
        for (std::size_t e = 0; e < all.moments.size(); ++e) all.moments[e] += x * state.moments[e];
        for (std::size_t j = 0; j < all.rotations.size(); ++j) all.rotations[j] += x * state.rotations[j];
        all.displacements.push_back(x * problem.sways[k].scale);
    }
}

} // namespace

Superposition superpose(const Model& model, const Problem& problem, const Procedure& procedure)
{
    Superposition all;
    PropForces forces(problem);
    all.held = held_stage(model, problem, procedure, forces);
    Procedure own = procedure;
    own.tolerance.reset(); // of the loads' moments, which say nothing of a sway's
    for (std::size_t k = 0; k < problem.sways.size(); ++k)
        all.sways.push_back(sway_stage(model, problem, k, own, forces));
    solve(model, all);
    const bool is_refined = !problem.sways.empty() && procedure.digits == 0 && !procedure.balances;
    if (is_refined && all.held.sheet.tolerance > 0.0) {
        own.tolerance = fitting_tolerance(all);
        for (std::size_t k = 0; k < all.sways.size(); ++k)
            if (all.sways[k].sheet.tolerance > *own.tolerance)
                all.sways[k] = sway_stage(model, problem, k, own, forces);
        solve(model, all);
    }
    add_up(problem, all);
    return all;
}

} // namespace femoop::cross
