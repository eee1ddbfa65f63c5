#pragma once

#include <optional>

#include "apps/cli/console.h"
#include "femoop/analysis/analysis_options.h"

namespace cli {

/// Seconds of `solve --time` beside those of the analysis.
struct PhaseTimes {
    double read = 0.0;
    std::optional<double> mesh{}; ///< of a model that is drawn
    double recover = 0.0, write = 0.0;
    bool has_refinement = false; ///< corrections and the backward error are told too
};

/// Tells on stderr how long each phase took, and the size of the system.
void report_time(const PhaseTimes& phases, const femoop::AnalysisStatistics& statistics, const Console& console);

} // namespace cli
