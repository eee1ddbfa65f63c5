#pragma once

#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/cross/distribution.h"
#include "femoop/methods/cross/superposition.h"
#include "femoop/result/results.h"

namespace femoop::cross {

/// What holds a structure in a state: how far its locks and its props have moved.
struct Locks {
    bool is_loaded = true;             ///< false: a sway alone, without loads
    std::vector<double> rotations;     ///< of every joint [rad]
    std::vector<double> displacements; ///< of every prop along its direction
    std::vector<double> dead_moments;  ///< on joints that are free already (FarEnds::ReleasedOnSheet); else empty
};

/// Locks of a state of the loads' sheet, of a sway's sheet, and of all sheets together.
Locks locks_of(const Problem& problem, const State& state);
Locks locks_of(const Problem& problem, const State& state, std::size_t sway);
Locks locks_of(const Problem& problem, const Superposition& all);

/// Locked joints make each state a real structure: the model with inextensible members, each joint clamped at its
/// rotation and each prop at its displacement, as a load case of its own. The analysis then gives reactions, N, V and M
/// and the deflected shape of the state, exactly. The reaction mz of a clamped joint is its unbalance and what a spring
/// there takes; the reaction of a prop is its holding force.
Model state_model(const Model& model, const Problem& problem, const Locks& locks);

/// Its one case is the last of the results: `results[state_case(results)]`.
Results state_results(const Model& model, const Problem& problem, const Locks& locks);

/// The same for one state after the other: locks change what they impose, never the structure, so its equations are
/// made and factored once.
class StateAnalysis {
public:
    StateAnalysis(const Model& model, const Problem& problem);
    /// \pre the model and the problem that it was made for
    Results solve(const Model& model, const Problem& problem, const Locks& locks);

private:
    LinearStatic analysis_;
};

inline CaseId state_case(const Results& results) { return CaseId(results.n_cases() - 1); }

/// Moments at every end as results hold them, on the member ends, counter-clockwise positive.
std::vector<double> end_moments(const Model& model, const Problem& problem, const CaseResult& result);

/// Section moment of an end moment, positive where it stretches the member's -y' fibre.
double section_moment(const End& end, double end_moment);

} // namespace femoop::cross
