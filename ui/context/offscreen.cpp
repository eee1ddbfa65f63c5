#include "ui/context/offscreen.h"

#include "ui/context/memory_picture.h"
#include "ui/context/offscreen_backend.h"
#include "ui/context/room_to_draw.h"

#include <cstring>
#include <utility>

namespace ui {

Offscreen::Offscreen(const Setup& setup) : setup_(setup), kind_(OffscreenKind::OsMesa)
{
    require_room_to_draw();
    FoundBackend found = any_offscreen_backend();
    kind_ = found.kind;
    backend_ = std::move(found.backend);
    make_picture();
}

Offscreen::Offscreen(const Setup& setup, OffscreenKind kind)
    : setup_(setup), kind_(kind), backend_(offscreen_backend(kind))
{
    make_picture();
}

Offscreen::~Offscreen()
{
    backend_->make_current();
    gl_->DeleteFramebuffers(1, &framebuffer_);
    gl_->DeleteRenderbuffers(1, &renderbuffer_);
}

void Offscreen::make_picture()
{
    gl_ = std::make_unique<gl::Functions>(backend_->loader());
    const auto& gl = *gl_;
    int largest = 0;
    gl.GetIntegerv(gl::max_renderbuffer_size, &largest);
    const auto [width, height] = setup_.size;
    if (width < 1 || height < 1 || width > largest || height > largest)
        throw ContextError("picture of " + std::to_string(width) + " x " + std::to_string(height) +
                           " pixels: each side must be from 1 to " + std::to_string(largest));
    gl.GenRenderbuffers(1, &renderbuffer_);
    gl.GenFramebuffers(1, &framebuffer_);
    make_memory_picture(gl, framebuffer_, renderbuffer_, setup_.size);
}

void Offscreen::make_current()
{
    backend_->make_current();
    gl_->BindFramebuffer(gl::framebuffer, framebuffer_);
}

std::string Offscreen::description() const
{
    const auto text = [&](gl::Enum what) { return std::string(reinterpret_cast<const char*>(gl_->GetString(what))); };
    return text(gl::renderer) + ", OpenGL " + text(gl::version);
}

Pixels Offscreen::pixels()
{
    make_current();
    const auto width = static_cast<std::size_t>(setup_.size.width),
               height = static_cast<std::size_t>(setup_.size.height);
    std::vector<std::uint8_t> upward(4 * width * height);
    gl_->PixelStorei(gl::pack_alignment, 1);
    gl_->ReadPixels(0, 0, setup_.size.width, setup_.size.height, gl::rgba, gl::unsigned_byte, upward.data());
    Pixels pixels{setup_.size, std::vector<std::uint8_t>(upward.size())};
    for (std::size_t row = 0; row < height; ++row) // OpenGL counts rows from the bottom
        std::memcpy(pixels.rgba.data() + 4 * width * row, upward.data() + 4 * width * (height - 1 - row), 4 * width);
    for (std::size_t i = 3; i < pixels.rgba.size(); i += 4) pixels.rgba[i] = 255;
    return pixels;
}

} // namespace ui
