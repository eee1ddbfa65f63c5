#include "ui/context/shared_library.h"

#include "ui/context/gl.h"

#if defined(_WIN32)
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace ui {

namespace {

#if defined(_WIN32)
void* open_library(const char* name) { return reinterpret_cast<void*>(LoadLibraryA(name)); }
void close_library(void* handle) { FreeLibrary(static_cast<HMODULE>(handle)); }
void* find_symbol(void* handle, const char* name)
{
    return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(handle), name));
}
std::string last_error() { return "error " + std::to_string(GetLastError()); }
#else
void* open_library(const char* name)
{ // Kept in memory: drivers leave threads and exit handlers behind, and leak checkers name what is still loaded.
    return dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
}
void close_library(void* handle) { dlclose(handle); }
void* find_symbol(void* handle, const char* name) { return dlsym(handle, name); }
std::string last_error()
{
    const char* text = dlerror();
    return text ? text : "no reason given";
}
#endif

} // namespace

SharedLibrary::SharedLibrary(const std::vector<std::string>& names)
{
    std::string reasons;
    for (const std::string& name : names) {
        handle_ = open_library(name.c_str());
        if (handle_) {
            name_ = name;
            return;
        }
        reasons += (reasons.empty() ? "" : "; ") + last_error();
    }
    throw ContextError(reasons);
}

SharedLibrary::~SharedLibrary() { close_library(handle_); }

void* SharedLibrary::symbol(const char* name) const { return find_symbol(handle_, name); }

void* SharedLibrary::required_symbol(const char* name) const
{
    void* found = symbol(name);
    if (!found) throw ContextError(name_ + " has no function " + name);
    return found;
}

} // namespace ui
