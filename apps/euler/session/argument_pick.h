#pragma once

#include <vector>

#include "apps/euler/document/palette/operator_form.h"
#include "topology/halfedge/solid.h"

namespace euler {

/// What a click on an entity means where an operator asks for another kind: the face of a half-edge, the vertex that it
/// starts at; of a vertex or an edge the half-edge that may be picked, if there is one alone. Else the entity itself.
topology::Entity as_argument(const topology::Solid& solid, ArgumentKind wanted, topology::Entity clicked,
                             const std::vector<topology::Entity>& legal);

} // namespace euler
