#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "femoop/methods/force_method/primary_structure.h"
#include "femoop/methods/virtual_work/virtual_work.h"
#include "femoop/result/results.h"

namespace femoop::force_method {

/// The force (flexibility) method: n redundants X are released; the primary structure that is left is solved under the
/// loads (state 0) and under each redundant as a unit load (states 1 to n); every gap that the loads open at a release
/// is closed again by the redundants:
///
///      sum over j of  delta_ij X_j  =  c_i - delta_i0        delta_ij: the gap at release i in state j, by virtual work
///                                                            c_i: what the support there is displaced by, else 0
///      S  =  S_0 + sum of X_i S_i                            any force or displacement
///
/// A redundant that goes through a spring strains it too: 1 / k is a part of its own delta_ii. Temperature, misfits and
/// settlements of what is not released are a part of delta_i0.
///
/// Fewer redundants than the degree of indeterminacy leave a primary structure that is indeterminate, whose states the
/// analysis solves all the same.
///
/// Signs    a redundant's own: femoop/result/curve.h, reactions along the axes of their support
/// Units    the model's base units
/// Accuracy that of the states; gaps are exact integrals (femoop/methods/virtual_work/virtual_work.h)
/// Source   [Kassimali, ch. 13]
struct ForceMethod {
    CaseId load_case; ///< of the whole structure
    std::vector<Redundant> redundants;
    Indeterminacy degree;      ///< of the whole structure
    PrimaryStructure primary;  ///< its model has the states as cases
    Results states;            ///< of that model
    std::vector<CaseId> cases; ///< state 0, states 1 to n
    CaseId superposition;      ///< the case that adds them up
    Eigen::MatrixXd delta;     ///< delta_ij [n x n], symmetric
    Eigen::VectorXd delta_0;   ///< delta_i0
    Eigen::VectorXd imposed;   ///< c_i
    Eigen::VectorXd X;
    Eigen::VectorXd analysed;                          ///< X as the analysis of the whole structure has them
    std::vector<std::vector<virtual_work::Work>> work; ///< for each i: that of states 0 to n on the forces of state i

    std::size_t n_redundants() const { return redundants.size(); }
    CaseResult state(std::size_t i) const { return states[cases[i]]; }
    CaseResult sum() const { return states[superposition]; }
};

/// \param results     of the model
/// \param redundants  which check_redundants finds sound; none: usual_redundants
/// \throws MechanismError  without its redundants the structure can move
///         ModelError      RedundantsNone, RedundantsTooMany, RedundantsUnstrained, or as `analyse`
ForceMethod solve(const Model& model, const Results& results, CaseId load_case, std::span<const Redundant> redundants);

} // namespace femoop::force_method
