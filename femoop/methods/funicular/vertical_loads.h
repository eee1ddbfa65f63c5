#pragma once

#include <optional>
#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/methods/funicular/chain.h"
#include "femoop/methods/funicular/refusal.h"
#include "femoop/model/model.h"

namespace femoop::funicular {

/// A vertical force at a place along the horizontal, down positive.
struct PointForce {
    double x = 0.0;
    double P = 0.0;
};

/// A vertical load per unit of horizontal length, down positive, linear, of one sign.
struct Stretch {
    double from = 0.0, to = 0.0; ///< from < to
    double start = 0.0, end = 0.0;

    double total() const { return 0.5 * (start + end) * (to - from); }
    double place() const
    {
        return from + (to - from) * (start + 2.0 * end) / (3.0 * (start + end));
    } ///< of its resultant
};

/// What acts down between the ends of a chain, each list from left to right.
struct VerticalLoads {
    std::vector<PointForce> forces;
    std::vector<Stretch> stretches;

    bool is_empty() const { return forces.empty() && stretches.empty(); }
};

/// Why the loads of a case are none that a funicular is drawn for: loads that are not vertical, or none at all. What
/// other members and supports do to nodes between the ends is no load.
std::optional<Refusal> why_no_vertical_loads(const Model& model, const Discretisation& structure, const Chain& chain,
                                             CaseId load_case);

/// All loads on the links, with their own weight where the case counts it, and on the nodes between the ends; forces
/// at the ends go straight into what holds these. Imposed strains are no loads.
///
/// Accuracy what is below 1e-9 of the largest force is 0
/// \pre why_no_vertical_loads says nothing; the chain is of the structure, that of the model
VerticalLoads vertical_loads(const Model& model, const Discretisation& structure, const Chain& chain, CaseId load_case);

} // namespace femoop::funicular
