#include "ui/context/offscreen_backend.h"

#include "ui/context/shared_library.h"

#include <array>
#include <string>
#include <utility>

namespace ui {

namespace {

/// OSMesa: Mesa drawing into memory that we own. Numbers from GL/osmesa.h.
class OsMesa final : public Offscreen::Backend {
public:
    OsMesa() : library_({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", "libOSMesa.8.dylib", "osmesa.dll"})
    {
        constexpr int format = 0x22, rgba = 0x1908, profile = 0x33, core_profile = 0x34, major = 0x36, minor = 0x37;
        const std::array<int, 9> wanted = {format, rgba, profile, core_profile, major, 3, minor, 3, 0};
        const auto create = library_.function<void* (*)(const int*, void*)>("OSMesaCreateContextAttribs");
        destroy_ = library_.function<void (*)(void*)>("OSMesaDestroyContext");
        bind_ = library_.function<Bind>("OSMesaMakeCurrent");
        loader_ = library_.function<gl::Loader>("OSMesaGetProcAddress");
        context_ = create(wanted.data(), nullptr);
        if (!context_) throw ContextError(library_.name() + " gives no OpenGL 3.3 core context");
        try {
            make_current();
        } catch (...) {
            destroy_(context_);
            throw;
        }
    }
    ~OsMesa() override { destroy_(context_); }

    void make_current() override
    {
        constexpr unsigned unsigned_byte = 0x1401;
        if (!bind_(context_, pixel_.data(), unsigned_byte, 1, 1))
            throw ContextError(library_.name() + ": OSMesaMakeCurrent refuses the context");
    }
    gl::Loader loader() const override { return loader_; }

private:
    using Bind = unsigned char (*)(void* context, void* buffer, unsigned type, int width, int height);

    SharedLibrary library_;
    void (*destroy_)(void*) = nullptr;
    Bind bind_ = nullptr;
    gl::Loader loader_ = nullptr;
    void* context_ = nullptr;
    std::array<unsigned char, 4> pixel_{}; // its own picture; we draw into a framebuffer object
};

/// EGL without a surface (EGL_MESA_platform_surfaceless). Numbers from EGL/egl.h and EGL/eglext.h.
class Egl final : public Offscreen::Backend {
public:
    Egl() : library_({"libEGL.so.1", "libEGL.so"})
    {
        loader_ = library_.function<gl::Loader>("eglGetProcAddress");
        bind_ = library_.function<Bind>("eglMakeCurrent");
        destroy_ = library_.function<Call2>("eglDestroyContext");
        open_display();
        try {
            create_context();
            make_current();
        } catch (...) {
            close();
            throw;
        }
    }
    ~Egl() override { close(); }

    void make_current() override
    {
        if (!bind_(display_, nullptr, nullptr, context_))
            throw ContextError("EGL: refuses a context without a surface");
    }
    gl::Loader loader() const override { return loader_; }

private:
    using Bind = unsigned (*)(void* display, void* draw, void* read, void* context);
    using Call2 = unsigned (*)(void* display, void* object);

    void open_display()
    {
        constexpr unsigned surfaceless_mesa = 0x31DD;
        using Display = void* (*)(unsigned platform, void* native, const int* attributes);
        const auto display_of = reinterpret_cast<Display>(loader_("eglGetPlatformDisplayEXT"));
        if (!display_of) throw ContextError("EGL: has no eglGetPlatformDisplayEXT");
        display_ = display_of(surfaceless_mesa, nullptr, nullptr);
        const auto initialize = library_.function<unsigned (*)(void*, int*, int*)>("eglInitialize");
        if (!display_ || !initialize(display_, nullptr, nullptr))
            throw ContextError("EGL: has no surfaceless display of Mesa's");
    }

    void create_context()
    {
        constexpr unsigned opengl_api = 0x30A2;
        constexpr int renderable_type = 0x3040, opengl_bit = 0x8, surface_type = 0x3033, none = 0x3038;
        constexpr int major = 0x3098, minor = 0x30FB, profile_mask = 0x30FD, core_profile = 1;
        if (!library_.function<unsigned (*)(unsigned)>("eglBindAPI")(opengl_api))
            throw ContextError("EGL: has no desktop OpenGL");
        using Choose = unsigned (*)(void*, const int*, void**, int, int*);
        const std::array<int, 5> wanted = {renderable_type, opengl_bit, surface_type, 0, none};
        void* config = nullptr;
        int n_configs = 0;
        library_.function<Choose>("eglChooseConfig")(display_, wanted.data(), &config, 1, &n_configs);
        if (n_configs < 1) throw ContextError("EGL: has no configuration for desktop OpenGL");
        using Create = void* (*)(void*, void*, void*, const int*);
        const std::array<int, 7> attributes = {major, 3, minor, 3, profile_mask, core_profile, none};
        context_ = library_.function<Create>("eglCreateContext")(display_, config, nullptr, attributes.data());
        if (!context_) throw ContextError("EGL: gives no OpenGL 3.3 core context");
    }

    /// The display stays open: all contexts of the program share it, and the drivers do not like to be unloaded.
    void close()
    {
        bind_(display_, nullptr, nullptr, nullptr);
        if (context_) destroy_(display_, context_);
    }

    SharedLibrary library_;
    gl::Loader loader_ = nullptr;
    Bind bind_ = nullptr;
    Call2 destroy_ = nullptr;
    void* display_ = nullptr;
    void* context_ = nullptr;
};

std::string reason_against(OffscreenKind kind, std::unique_ptr<Offscreen::Backend>& made)
{
    try {
        made = offscreen_backend(kind);
        return {};
    } catch (const ContextError& error) {
        return error.what();
    }
}

} // namespace

std::unique_ptr<Offscreen::Backend> offscreen_backend(OffscreenKind kind)
{
    if (kind == OffscreenKind::Empty) return std::make_unique<EmptyBackend>();
    if (kind == OffscreenKind::OsMesa) return std::make_unique<OsMesa>();
    return std::make_unique<Egl>();
}

FoundBackend any_offscreen_backend()
{
    std::unique_ptr<Offscreen::Backend> found;
    const std::string without_osmesa = reason_against(OffscreenKind::OsMesa, found);
    if (found) return {OffscreenKind::OsMesa, std::move(found)};
    const std::string without_egl = reason_against(OffscreenKind::Egl, found);
    if (found) return {OffscreenKind::Egl, std::move(found)};
    throw ContextError("no off-screen renderer: OSMesa: " + without_osmesa + "; EGL: " + without_egl +
                       "; install the package libosmesa6 (or libegl1 and libgl1-mesa-dri)");
}

} // namespace ui
