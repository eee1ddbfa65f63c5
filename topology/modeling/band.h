#pragma once

#include <vector>

#include "topology/halfedge/operators/euler_operator.h"

namespace topology {

/// Fills a face of two loops with n corners each, which run in opposite directions, with quadrilaterals: MEKR of the
/// two corners, and MEF of the corners that follow, forward from `from` and backward from `to`. \returns for each
/// corner of `from`'s loop the half-edge from it to its partner
std::vector<HalfEdgeId> add_band(EulerOperator& op, HalfEdgeId from, HalfEdgeId to);

} // namespace topology
