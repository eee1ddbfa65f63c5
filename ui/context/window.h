#pragma once

#include "ui/context/context.h"
#include "ui/context/input.h"
#include "ui/context/typing.h"

#include <memory>
#include <string>

namespace ui {

enum class PointerShape { Arrow, Text, Hand, Crosshair, ResizeAcross, ResizeUpDown };

/// A window on the screen, through GLFW; of a page in a browser its canvas (web/window.cpp).
class Window final : public Context {
public:
    struct Setup {
        std::string title;
        Size size{1280.0, 800.0}; ///< logical pixels
    };

    /// \throws ContextError with the system's words when there is no display or no OpenGL 3.3 (WebGL 2).
    explicit Window(const Setup& setup);
    ~Window() override;

    void make_current() override;
    PixelSize size() const override;
    double scale() const override;
    const gl::Functions& gl() const override;
    void present() override;

    bool wants_to_close() const;
    /// Takes back a wish to close: the document is not saved yet.
    void stay_open();
    void close();
    void set_title(const std::string& title);
    void set_pointer(PointerShape shape);
    std::string clipboard() const;
    void set_clipboard(const std::string& text);

    /// Waits for something to happen, `patience` seconds at most. False where it cannot wait, as in a browser, and
    /// nothing has happened: ask again at the browser's next frame.
    bool wait(double patience);
    /// What happened since the last call, without what was typed.
    Input input();
    /// What was typed until the last `input`.
    Typing& typing();

    /// True where a window can be opened at all.
    static bool has_display();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace ui
