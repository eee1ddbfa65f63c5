#include "femoop/solver/cholmod_solver.h"

namespace femoop {

bool has_cholmod() { return false; }
std::unique_ptr<SymmetricSolver> make_cholmod_solver() { return nullptr; }

} // namespace femoop
