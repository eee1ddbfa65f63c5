#pragma once

#include <cstdint>
#include <vector>

#include "femoop/solver/block_graph.h"

namespace femoop {

/// Nested dissection by METIS through CHOLMOD; empty where the library is built without CHOLMOD or that without METIS.
std::vector<std::int32_t> nested_dissection(const BlockAdjacency& adjacency);

} // namespace femoop
