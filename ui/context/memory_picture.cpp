#include "ui/context/memory_picture.h"

namespace ui {

void make_memory_picture(const gl::Functions& gl, gl::Uint framebuffer, gl::Uint renderbuffer, PixelSize size)
{
    gl.BindFramebuffer(gl::framebuffer, framebuffer);
    gl.BindRenderbuffer(gl::renderbuffer, renderbuffer);
    gl.RenderbufferStorage(gl::renderbuffer, gl::rgba8, size.width, size.height);
    gl.FramebufferRenderbuffer(gl::framebuffer, gl::color_attachment0, gl::renderbuffer, renderbuffer);
    if (gl.CheckFramebufferStatus(gl::framebuffer) != gl::framebuffer_complete)
        throw ContextError("OpenGL: the driver cannot draw into a picture in memory");
}

} // namespace ui
