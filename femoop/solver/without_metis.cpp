#include "femoop/solver/metis_ordering.h"

namespace femoop {

std::vector<std::int32_t> metis_order(const BlockAdjacency&) { return {}; }

} // namespace femoop
