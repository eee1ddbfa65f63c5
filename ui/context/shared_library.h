#pragma once

#include <string>
#include <vector>

namespace ui {

/// A library opened while the program runs, so that the program starts where it is missing.
class SharedLibrary {
public:
    /// Opens the first of the names that there is. \throws ContextError with the loader's words about each.
    explicit SharedLibrary(const std::vector<std::string>& names);
    ~SharedLibrary();
    SharedLibrary(const SharedLibrary&) = delete;
    SharedLibrary& operator=(const SharedLibrary&) = delete;

    /// Null where there is none.
    void* symbol(const char* name) const;
    /// \throws ContextError where there is none.
    template <class Function> Function function(const char* name) const
    {
        return reinterpret_cast<Function>(required_symbol(name));
    }
    const std::string& name() const { return name_; }

private:
    void* required_symbol(const char* name) const;

    void* handle_ = nullptr;
    std::string name_;
};

} // namespace ui
