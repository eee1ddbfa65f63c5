#pragma once

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

namespace femoop {

/// A function by its name, if any library of the running program has it. Which OpenMP and which BLAS come with CHOLMOD
/// is decided when the program is loaded, so their own functions cannot be linked.
template <class Function> Function* loaded_function([[maybe_unused]] const char* name)
{
#if __has_include(<dlfcn.h>)
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
#else
    return nullptr;
#endif
}

} // namespace femoop
