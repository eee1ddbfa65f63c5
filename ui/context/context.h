#pragma once

#include "ui/context/gl.h"
#include "ui/paint/geometry.h"

namespace ui {

/// Width and height in physical pixels.
struct PixelSize {
    int width = 0;
    int height = 0;

    friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// Something that OpenGL 3.3 core draws into: a window or memory. Only this folder makes contexts.
/// Use an object on the thread that made it.
class Context {
public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// Makes it the one that OpenGL calls go to, and its picture the one they draw on.
    virtual void make_current() = 0;
    virtual PixelSize size() const = 0;
    /// Physical pixels of a logical one: 2 on a HiDPI screen.
    virtual double scale() const = 0;
    /// \pre current
    virtual const gl::Functions& gl() const = 0;
    /// Shows what was drawn; nothing to do off screen.
    virtual void present() = 0;

protected:
    Context() = default;
};

inline Size logical_size(const Context& context)
{
    const PixelSize pixels = context.size();
    return {pixels.width / context.scale(), pixels.height / context.scale()};
}

} // namespace ui
