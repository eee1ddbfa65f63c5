#pragma once

#include "apps/euler/view/subject.h"

#include <string>

namespace euler {

/// As pictures name it: half-edges as corners of scripts write them, "%7"; edges and loops as the tables do, "e3";
/// vertices and faces by the user's names.
std::string entity_name(const Subject& subject, topology::Entity entity);

} // namespace euler
