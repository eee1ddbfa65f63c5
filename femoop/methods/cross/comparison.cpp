#include "femoop/methods/cross/comparison.h"

#include <algorithm>
#include <cmath>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/cross/slope_deflection.h"
#include "femoop/methods/cross/state_model.h"

namespace femoop::cross {

namespace {

/// Forgets what is no more than rounding.
void clean(std::vector<double>& moments, double least)
{
    for (double& moment : moments)
        if (std::abs(moment) < least) moment = 0.0;
}

} // namespace

Comparison compare(const Model& model, const Problem& problem, const std::vector<double>& distributed)
{
    constexpr double rounding = 1e-12; // of the numbers that the analysis adds up
    Comparison all{
        .distributed = distributed, .limit = {}, .inextensible = {}, .stiffness = {}, .apart = {}, .difference = {}};
    const Results own = analyse(model);
    all.stiffness = end_moments(model, problem, own[problem.load_case]);
    all.inextensible = end_moments(model, problem, analyse(inextensible_copy(model))[problem.load_case]);
    all.limit = slope_deflection(model, problem).moments;
    const double least = rounding * own[problem.load_case].magnitudes().moment;
    for (std::size_t e = 0; e < distributed.size(); ++e) all.apart.push_back(distributed[e] - all.stiffness[e]);
    for (auto* const moments : {&all.limit, &all.inextensible, &all.stiffness, &all.apart}) clean(*moments, least);
    for (const Joint& joint : problem.joints) {
        double largest = 0.0;
        for (const EndId e : joint.ends) largest = std::max(largest, std::abs(all.apart[e.index]));
        all.difference.push_back(largest);
    }
    return all;
}

} // namespace femoop::cross
