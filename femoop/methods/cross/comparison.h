#pragma once

#include <optional>
#include <vector>

#include "femoop/methods/cross/problem.h"
#include "femoop/result/results.h"

namespace femoop::cross {

/// Final moments beside those of the stiffness method, at every end. What is nothing but rounding beside the case's
/// forces and the structure's size is 0.
struct Comparison {
    std::vector<double> distributed;  ///< of the sheets
    std::vector<double> limit;        ///< what the sheets tend to: the slope-deflection equations solved
    std::vector<double> inextensible; ///< the analysis, every member inextensible
    std::vector<double> stiffness;    ///< the analysis of the model as it is
    std::vector<double> apart;        ///< distributed - stiffness
    std::vector<double> difference;   ///< of every joint: the largest of its ends
};

/// \throws as `slope_deflection` and `analyse`
Comparison compare(const Model& model, const Problem& problem, const std::vector<double>& distributed);

} // namespace femoop::cross
