#pragma once

#include "apps/frame/tables/columns.h"
#include "apps/frame/tables/table.h"
#include "femoop/result/results.h"

namespace frame {

/// Which results a table shows.
struct TabledResults {
    const femoop::Model& model;
    const femoop::Results& results; ///< of this model
    femoop::CaseId load_case;       ///< the envelope is of all cases and combinations
};

/// A table of results, with what is nothing but rounding as 0.
///
///   Displacements  node, displacements and rotations
///   Reactions      supported node, forces and moments
///   MemberEnds     member, the section forces at its start and at its end
///   Extremes       member, the largest and smallest of each section force and where they are
///   Envelope       member, the largest and smallest of each over all cases, and the case that governs
///
/// \pre is_result(kind); the results have the case
Table result_table(const TabledResults& results, TableKind kind, const Manner& manner);

} // namespace frame
