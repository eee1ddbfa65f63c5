#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "apps/cross/document/document.h"
#include "femoop/methods/cross/comparison.h"
#include "femoop/methods/cross/kani.h"
#include "femoop/methods/cross/slope_deflection.h"
#include "femoop/methods/cross/state_model.h"
#include "femoop/methods/cross/superposition.h"

namespace cross {

/// What follows from a structure and a method, before any sheet is worked.
struct Task {
    femoop::cross::Problem problem;
    femoop::cross::Procedure procedure;
    /// What symmetry offers, taken or not; else why it offers nothing.
    std::optional<femoop::cross::Problem> by_halves{};
    std::optional<femoop::Fault> why_not_by_halves{};
    /// Worked to the tolerance by the method's own order; nothing where that does not come to an end.
    std::optional<femoop::cross::Superposition> all{};
    std::optional<femoop::cross::Comparison> comparison{};
    std::optional<femoop::cross::Kani> kani{};
    std::optional<femoop::cross::SlopeDeflection> equations{};
    std::optional<femoop::Results> balanced{}; ///< the structure with every lock and prop gone
    std::vector<femoop::Fault> remarks{};      ///< why something of this is missing

    std::size_t n_sheets() const { return 1 + problem.sways.size(); }
    /// Of the loads with every prop in place (stage 0), or of a sway alone.
    const femoop::cross::Loading& loading(std::size_t stage) const
    {
        return stage == 0 ? problem.loading : problem.sways[stage - 1].loading;
    }
};

/// What is known of a document: a pure function of it.
struct Solution {
    std::vector<femoop::Fault> faults; ///< why there is no task
    std::optional<Task> task;
    std::vector<femoop::cross::Sheet> sheets; ///< as far as they are worked, one for every stage
    std::vector<std::vector<double>> held;    ///< by each sway's prop at the end of every sheet, along its direction

    /// The sheet that is worked on; null where all are seen together, or where there is none.
    const femoop::cross::Sheet* sheet(const Document& document) const;
    /// What it is worked on: half of the structure by symmetry, else the whole. \pre there is a task
    const femoop::cross::Problem& sheet_problem(const Document& document) const
    {
        return task->problem.of_sheet(document.stage);
    }
};

/// While a hand drags, Kani's method waits: in tall frames it goes through thousands of cycles.
enum class SolveMode : std::uint8_t { Full, Interactive };

/// Never throws for what a model may contain.
Solution solve(const Document& document, SolveMode mode = SolveMode::Full);
/// The sheets alone, after turns were taken or taken back.
void work(Solution& solution, const Document& document);

/// How far locks and props have moved where the document stands. \pre there is a task
/// \param phase  how much of the last turn is done, 0 to 1: a joint on its way is a real structure too
femoop::cross::Locks present_locks(const Document& document, const Solution& solution, double phase = 1.0);

/// Moments at every end where the document stands: of its sheet, or of all sheets together.
std::vector<double> present_moments(const Document& document, const Solution& solution);

/// The force that each sway's prop holds now, along its direction: in the loaded structure, or in the sway of the
/// stage. \pre one sheet is worked on
std::vector<double> held_by_props(const Document& document, const Solution& solution);

/// Whose turn would be next by the method's order; nothing where no joint can be balanced.
std::optional<TurnTree::Turn> next_turn(const Document& document, const Solution& solution);

} // namespace cross
