#pragma once

#include <vector>

#include "apps/frame/tables/columns.h"
#include "apps/frame/tables/table.h"
#include "femoop/result/results.h"

namespace frame {

/// Which results a table shows.
struct TabledResults {
    const femoop::Model& model;
    const femoop::Results& results;            ///< of this model
    femoop::CaseId load_case;                  ///< for tables of one case
    std::vector<femoop::CaseId> envelope_of{}; ///< for tables of several; all cases and combinations where it is empty
};

/// A table of results, with what is nothing but rounding as 0.
///
///   Displacements  node, displacements and rotations
///   Reactions      supported node, forces and moments
///   MemberEnds     member, the section forces at its start and at its end
///   Extremes       member, the largest and smallest of each section force and where they are
///   Envelope       member, the largest and smallest of each over several cases, and the case that governs
///   ReactionEnvelope  the same of the reactions of every supported node
///
/// \pre is_result(kind); the results have the case
Table result_table(const TabledResults& results, TableKind kind, const Manner& manner);

} // namespace frame
