#pragma once

#include "ui/context/context.h"

namespace ui {

/// Gives a framebuffer, which is bound from here on, a picture of this size to draw on, kept by the renderbuffer.
/// \pre the context of `gl` is current
/// \throws ContextError when the driver has no such picture.
void make_memory_picture(const gl::Functions& gl, gl::Uint framebuffer, gl::Uint renderbuffer, PixelSize size);

} // namespace ui
