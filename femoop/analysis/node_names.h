#pragma once

#include <string>
#include <vector>

#include "femoop/model/model.h"

namespace femoop {

/// The nodes' names as one argument of a fault; of many only the first, and how many more there are.
std::string names_of(const Model& model, const std::vector<NodeId>& nodes);

} // namespace femoop
