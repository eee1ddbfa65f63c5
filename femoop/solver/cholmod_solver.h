#pragma once

#include <memory>

#include "femoop/solver/symmetric_solver.h"

namespace femoop {

bool has_cholmod();

/// SuiteSparse's supernodal L L': dense blocks through the BLAS, for large systems. Its supernodal module is GPL, so it
/// is optional and shows in no public header; nothing where the library is built without it.
/// Source  [ChenDavis2008]
std::unique_ptr<SymmetricSolver> make_cholmod_solver();

} // namespace femoop
