#include "ui/context/offscreen_backend.h"

#include <emscripten.h>
#include <emscripten/html5.h>

// clang-format off
// A canvas that no page shows, by a name that html5.h finds it by.
EM_JS(int, web_make_hidden_canvas, (), {
    if (typeof document === 'undefined') return 0;
    specialHTMLTargets['!hidden'] = document.createElement('canvas');
    return 1;
});
// clang-format on

namespace ui {

namespace {

class HiddenCanvas final : public Offscreen::Backend {
public:
    HiddenCanvas()
    {
        if (!web_make_hidden_canvas()) throw ContextError("pictures of pixels are drawn by a browser alone");
        EmscriptenWebGLContextAttributes wanted;
        emscripten_webgl_init_context_attributes(&wanted);
        wanted.majorVersion = 2;
        wanted.depth = wanted.antialias = false;
        context_ = emscripten_webgl_create_context("!hidden", &wanted);
        if (context_ <= 0) throw ContextError("this browser gives no further picture of WebGL 2");
        HiddenCanvas::make_current();
    }
    ~HiddenCanvas() override { emscripten_webgl_destroy_context(context_); }

    void make_current() override { emscripten_webgl_make_context_current(context_); }
    gl::Loader loader() const override
    {
        return [](const char* name) { return reinterpret_cast<gl::Proc>(emscripten_webgl_get_proc_address(name)); };
    }

private:
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context_ = 0;
};

} // namespace

std::unique_ptr<Offscreen::Backend> offscreen_backend(OffscreenKind kind)
{
    if (kind == OffscreenKind::Empty) return std::make_unique<EmptyBackend>();
    return std::make_unique<HiddenCanvas>();
}

FoundBackend any_offscreen_backend() { return {OffscreenKind::WebGl, std::make_unique<HiddenCanvas>()}; }

} // namespace ui
