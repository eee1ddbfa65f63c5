#pragma once

#include <cstddef>

#include "femoop/analysis/analysis_options.h"
#include "femoop/plane/model/plane_model.h"

namespace cli {

/// The unit square of `cremona bench plane`: n by n elements in plane stress, E 1, nu 0.3, thickness 1; its left side is
/// fixed, qy = 1 acts on its right side.
femoop::plane::PlaneModel unit_square(std::size_t n, femoop::ShapeKind element);

/// What it costs, in seconds, from the mesh in memory to the stresses at 4 points of each element.
struct PlaneBench {
    femoop::AnalysisStatistics statistics;
    double recover = 0.0;
    double total = 0.0;
    double peak_mb = 0.0; ///< of the whole process
    double tip = 0.0;     ///< uy at (1, 0.5)
    double sum = 0.0;     ///< of what was recovered, so that nothing can be left out
};
PlaneBench bench_plane(femoop::plane::PlaneModel model, const femoop::AnalysisOptions& options);

} // namespace cli
