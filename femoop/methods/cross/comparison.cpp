#include "femoop/methods/cross/comparison.h"

#include <algorithm>
#include <cmath>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/cross/slope_deflection.h"
#include "femoop/methods/cross/state_model.h"

namespace femoop::cross {

Comparison compare(const Model& model, const Problem& problem, const std::vector<double>& distributed)
{
    Comparison all{.distributed = distributed, .limit = {}, .inextensible = {}, .stiffness = {}, .difference = {}};
    all.stiffness = end_moments(model, problem, analyse(model)[problem.load_case]);
    all.inextensible = end_moments(model, problem, analyse(inextensible_copy(model))[problem.load_case]);
    all.limit = slope_deflection(model, problem).moments;
    for (const Joint& joint : problem.joints) {
        double largest = 0.0;
        for (const EndId e : joint.ends)
            largest = std::max(largest, std::abs(distributed[e.index] - all.stiffness[e.index]));
        all.difference.push_back(largest);
    }
    return all;
}

} // namespace femoop::cross
