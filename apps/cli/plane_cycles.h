#pragma once

#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/plane/discretize/drawing.h"
#include "apps/plane/discretize/meshed_drawing.h"
#include "femoop/analysis/analysis_options.h"

namespace cli {

/// Of `solve --cycles`.
struct CycleQuestion {
    const discretize::Drawing& drawing;
    const discretize::MeshedDrawing& mesh; ///< its own, from which the cycle starts
    std::string file;                      ///< as messages call it
    std::vector<femoop::CaseId> cases{};   ///< each with a cycle of its own
    std::size_t n_cycles = 1;              ///< at most
    bool is_json = false;
};

/// Refines the mesh by the error and prints what each mesh has, and how fast the error falls. \throws UsageError where a
/// region is to be mapped
ExitStatus print_cycles(const CycleQuestion& question, const femoop::AnalysisOptions& options, Console& console);

} // namespace cli
