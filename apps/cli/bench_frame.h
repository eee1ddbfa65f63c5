#pragma once

#include <cstddef>

#include "femoop/analysis/linear_static.h"
#include "femoop/model/model.h"

namespace cli {

struct FrameSize {
    std::size_t bays = 1, storeys = 1;
};

/// The plane frame of `cremona bench frame`: bays of 6 m, storeys of 3 m, fixed bases; E 210 GPa; columns A 0.01 m2,
/// I 1e-4 m4; beams A 0.008 m2, I 2e-4 m4; 20 kN/m down on every beam, 10 kN to the right at the left node of every
/// level.
femoop::Model plane_frame(FrameSize size);

double peak_megabytes(); ///< of memory, of the whole process so far

/// What it costs, in seconds, from the model in memory to the last station.
struct FrameBench {
    femoop::AnalysisStatistics statistics;
    double recover = 0.0; ///< N, V and M at 11 stations of every member
    double total = 0.0;
    double resolve = 0.0; ///< the same structure with other loads, up to its displacements
    double peak_mb = 0.0; ///< of the whole process
    double sway = 0.0;    ///< ux of the top left node [m]
    double sum = 0.0;     ///< of what was recovered, so that nothing can be left out
};
FrameBench bench_frame(FrameSize size, const femoop::AnalysisOptions& options);

} // namespace cli
