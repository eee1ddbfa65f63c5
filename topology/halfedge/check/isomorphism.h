#pragma once

#include <cstdint>

#include "topology/halfedge/solid.h"

namespace topology {

/// What two solids are compared by.
enum class Isomorphism : std::uint8_t {
    Structure, ///< the links: which entity bounds which, and which loops are outer ones
    Places     ///< the links, and where the vertices are
};

/// Are the two the same but for the numbers of their entities, for which half an edge's is the plus one, and for where
/// lists begin? That is, is there an isomorphism. Mirror images are not alike unless the solid is its own mirror image.
/// Accuracy places agree up to 1e-9 of the larger coordinate
/// Cost     each part that edges connect is laid upon the other's at every corner until it fits, and one part's wrong
///          place is found out only with the next; for solids as students make them
bool are_alike(const Solid& a, const Solid& b, Isomorphism by = Isomorphism::Structure);

} // namespace topology
