#pragma once

#if defined(FEMOOP_HAS_CHOLMOD) && __has_include(<dlfcn.h>)
#define FEMOOP_LOADS_FUNCTIONS
#include <dlfcn.h>
#endif

namespace femoop {

/// A function by its name, if any library of the running program has it. Which OpenMP and which BLAS come with CHOLMOD
/// is decided when the program is loaded, so their own functions cannot be linked. Without CHOLMOD there is none.
template <class Function> Function* loaded_function([[maybe_unused]] const char* name)
{
#ifdef FEMOOP_LOADS_FUNCTIONS
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
#else
    return nullptr;
#endif
}

} // namespace femoop
