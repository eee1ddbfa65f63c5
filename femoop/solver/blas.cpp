#include "femoop/solver/blas.h"

#include "femoop/solver/cholmod_solver.h"
#include "femoop/solver/loaded_function.h"

namespace femoop {

Blas blas()
{
    if (!has_cholmod()) return {.name = "none", .threads = 1};
    const auto config = loaded_function<const char*()>("openblas_get_config");
    const auto threads = loaded_function<int()>("openblas_get_num_threads");
    if (config != nullptr && threads != nullptr) return {.name = config(), .threads = threads()};
    return {.name = "BLAS of unknown make", .threads = 1};
}

} // namespace femoop
