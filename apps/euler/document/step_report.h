#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/operators/change.h"
#include "ui/text/message.h"

namespace euler {

/// One step of a lesson, in short: what stands in a list of all steps.
struct StepSummary {
    std::string line;                    ///< as the script has it, with the comment at its end
    std::string name;                    ///< of the operator: "MEV", or "SWEEP", which is many
    std::size_t solid = 0;               ///< its place in the runner's solids()
    topology::EulerCounts before, after; ///< of that solid; all 0 before its first step
};

/// All that there is to say of one step.
struct StepReport : StepSummary {
    std::vector<topology::Change> changes; ///< one for each operator
    std::string inverse_name;              ///< "KEV"; of a sweep, and where one is not enough, "KEF, KEV"
    std::vector<std::string> inverse;      ///< the lines that would take the step back: "kev s1 v1 v2"
    ui::Message warning;                   ///< what is odd about places, though all links are right; may be empty
    ui::Message meaning;                   ///< what the line did, in a sentence
    ui::Message explanation;               ///< the comment just above the step and at its end; may be empty
};

/// The six differences in the order of the formula, V E F L S G: "MEF: 0 +1 +1 +1 0 0".
std::string deltas(const StepSummary& step);

/// What all of a step's operators did, taken together: what came and went within the step is not told.
topology::Change together(const std::vector<topology::Change>& changes);

} // namespace euler
