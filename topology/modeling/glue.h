#pragma once

#include "topology/halfedge/operators/euler_operator.h"

namespace topology {

/// Glues two faces whose corners lie at the same places, one turned against the other, as two stacked blocks have them.
///
///      +----+            +----+       KFMRH of the faces, a band between their loops (MEKR, MEF),
///      |    |            |    |       whose edges across shrink to nothing (KEV) and whose faces,
///      +----+ f          |    |       then of two edges, close (KEF).
///      +----+ g    ->    +----+
///      |    |            |    |       Of n corners: V-n E-n F-2 L-2, and S-1 of two shells
///      +----+            +----+       or G+1 of one
///
/// Survive  the corners and edges of f; neither face
/// `within` is how far apart corners may lie. \throws EulerError
void glue(EulerOperator& op, FaceId f, FaceId g, double within = 1e-9);
std::optional<Refusal> why_not_glue(const EulerOperator& op, FaceId f, FaceId g, double within = 1e-9);

} // namespace topology
