#include "femoop/solver/blas.h"

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

#include "femoop/solver/cholmod_solver.h"

namespace femoop {

Blas blas()
{
    if (!has_cholmod()) return {.name = "none", .threads = 1};
#if __has_include(<dlfcn.h>)
    // Which BLAS the program got is decided when it is loaded: it is asked by name.
    const auto config = reinterpret_cast<const char* (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_config"));
    const auto threads = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads"));
    if (config != nullptr && threads != nullptr) return {.name = config(), .threads = threads()};
#endif
    return {.name = "BLAS of unknown make", .threads = 1};
}

} // namespace femoop
