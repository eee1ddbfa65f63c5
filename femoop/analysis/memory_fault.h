#pragma once

#include <Eigen/Core>

#include "femoop/model/fault/fault.h"
#include "femoop/solver/available_memory.h"

namespace femoop {

/// What a system is refused with that the memory cannot hold.
Fault insufficient_memory(const InsufficientMemory& refusal, Eigen::Index n_equations);

} // namespace femoop
