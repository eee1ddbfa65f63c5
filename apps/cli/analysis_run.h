#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace cli {

/// A model solved, and what it cost.
struct Solved {
    femoop::Results results;
    femoop::AnalysisStatistics statistics;
};

/// Solves the model; if it cannot be solved, stderr says why (every mechanism in words) and the status is returned:
/// CannotSolve for a mechanism and for constraints that contradict the loads, else BadInput.
std::variant<Solved, ExitStatus> solve_model(const femoop::Model& model, const std::string& file,
                                             const femoop::AnalysisOptions& options, const Console& console);

/// Says on stderr that the structure can move, and each of its motions in words.
void report_mechanisms(const femoop::MechanismError& error, const std::string& file, const Console& console);

/// Says on stderr why a model cannot be solved: its mechanisms in words, else its faults. \returns the status
ExitStatus report_unsolved(const femoop::ModelError& error, const std::string& file, const Console& console);

/// Constraints that contradict a settlement are the structure's fault (CannotSolve), all else is the file's.
ExitStatus status_of(const std::vector<femoop::Fault>& faults);

/// What `--describe` has to say, for programs.
std::string description_json(const std::string& sentences);

/// The solver of this name (automatic, skyline, multifrontal, ldlt, cholmod), of those that the program is built with.
/// \throws UsageError
femoop::SolverKind solver_named(const std::string& name, const ui::Catalogue& tr);

} // namespace cli
