#include "femoop/solver/cholmod_ordering.h"
#include "femoop/solver/cholmod_solver.h"

namespace femoop {

bool has_cholmod() { return false; }
std::unique_ptr<SymmetricSolver> make_cholmod_solver() { return nullptr; }
std::vector<std::int32_t> nested_dissection(const BlockAdjacency&) { return {}; }

} // namespace femoop
