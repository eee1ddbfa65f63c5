#pragma once

#include <cstdint>
#include <vector>

#include "femoop/solver/block_graph.h"

namespace femoop {

/// Nested dissection of the graph by METIS; empty where the library is built without it.
std::vector<std::int32_t> metis_order(const BlockAdjacency& adjacency);

} // namespace femoop
