#pragma once

#include "femoop/analysis/analysis_options.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop {

/// The algorithm of an analysis: what is solved, how often, and in what order. It knows a system of equations and no
/// element; an element knows no control.
///
/// Source  [MarthaParente2002]: the class Control
class Control {
public:
    virtual ~Control() = default;

    /// Solves the loads of `model`. \throws ModelError, MechanismError
    virtual Results solve(const Model& model) = 0;

    virtual const AnalysisStatistics& statistics() const = 0;
};

} // namespace femoop
