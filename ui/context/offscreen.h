#pragma once

#include "ui/context/context.h"
#include "ui/context/pixels.h"

#include <memory>
#include <string>

namespace ui {

/// Which off-screen renderer: OSMesa draws in memory with no help of the system; EGL is asked for a surfaceless
/// context of Mesa's, where OSMesa is missing (newer Mesa has dropped it); in a browser it is a canvas that no page
/// shows. Empty draws nothing: its pictures are black.
enum class OffscreenKind { OsMesa, Egl, WebGl, Empty };

/// Draws into memory, without a display. The library behind it is opened when the first one is made, never linked.
class Offscreen final : public Context {
public:
    struct Setup {
        PixelSize size{1280, 800};
        double scale = 1.0;
    };

    /// Tries OSMesa, then EGL; in a browser there is but one kind.
    /// \throws ContextError with what was found wrong with each and the package to install
    explicit Offscreen(const Setup& setup);
    /// Only that kind. \throws ContextError
    Offscreen(const Setup& setup, OffscreenKind kind);
    ~Offscreen() override;

    void make_current() override;
    PixelSize size() const override { return setup_.size; }
    double scale() const override { return setup_.scale; }
    const gl::Functions& gl() const override { return *gl_; }
    void present() override {}

    OffscreenKind kind() const { return kind_; }
    /// Renderer and version in OpenGL's words.
    std::string description() const;
    /// What was drawn, from the top row down.
    Pixels pixels();

    class Backend; ///< one per kind (offscreen_backend.h)

private:
    void make_picture();

    Setup setup_;
    OffscreenKind kind_;
    std::unique_ptr<Backend> backend_;
    std::unique_ptr<gl::Functions> gl_;
    gl::Uint framebuffer_ = 0;
    gl::Uint renderbuffer_ = 0;
};

} // namespace ui
