#pragma once

#include "ui/context/empty_gl.h"
#include "ui/context/offscreen.h"

#include <memory>

namespace ui {

/// A current OpenGL 3.3 core context that belongs to no window.
class Offscreen::Backend {
public:
    virtual ~Backend() = default;
    virtual void make_current() = 0;
    virtual gl::Loader loader() const = 0;
};

/// Of the kind Empty.
class EmptyBackend final : public Offscreen::Backend {
public:
    void make_current() override {}
    gl::Loader loader() const override { return gl::empty_function; }
};

/// \throws ContextError with what was found wrong
std::unique_ptr<Offscreen::Backend> offscreen_backend(OffscreenKind kind);

/// The first kind that there is. \throws ContextError with what was found wrong with each and the package to install
struct FoundBackend {
    OffscreenKind kind;
    std::unique_ptr<Offscreen::Backend> backend;
};
FoundBackend any_offscreen_backend();

} // namespace ui
