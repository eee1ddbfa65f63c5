#include "ui/context/window.h"

#include "ui/context/button_events.h"
#include "ui/context/touch_gesture.h"
#include "ui/context/web/key_names.h"

#include <emscripten.h>
#include <emscripten/html5.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>
#include <vector>

// The window of a page: its canvas, which has the id "canvas". What html5.h has not stands here in the page's language.
// clang-format off
EM_JS(int, web_has_page, (), { return typeof document !== 'undefined' && !!Module['canvas']; });
EM_JS(double, web_canvas_left, (), { return Module['canvas'].getBoundingClientRect().left; });
EM_JS(double, web_canvas_top, (), { return Module['canvas'].getBoundingClientRect().top; });
EM_JS(void, web_set_cursor, (const char* name), { Module['canvas'].style.cursor = UTF8ToString(name); });
EM_JS(void, web_tell_whether_text_is_wanted, (int isWanted), { Module['wantsText'] = !!isWanted; });
EM_JS(void, web_set_title, (const char* title), { document.title = UTF8ToString(title); });
// The clipboard can be read only while something is pasted, so what was pasted last is kept; a copy can be pasted too.
EM_JS(void, web_listen_to_clipboard, (), {
    Module['clipboardText'] = "";
    document.addEventListener('paste', (event) => {
        Module['clipboardText'] = event.clipboardData.getData('text/plain');
    });
});
EM_JS(char*, web_clipboard, (), { return allocateUTF8(Module['clipboardText']); });
EM_JS(void, web_set_clipboard, (const char* text), {
    Module['clipboardText'] = UTF8ToString(text);
    if (navigator.clipboard) navigator.clipboard.writeText(Module['clipboardText']).catch(() => {});
});
// Files that the page put into the file system: chosen or dropped (page.js).
EM_JS(char*, web_next_file, (), {
    const path = (Module['openedFiles'] || []).shift();
    return path ? allocateUTF8(path) : 0;
});
// clang-format on

namespace ui {

namespace {

constexpr const char* canvas = "#canvas";

double now() { return 1e-3 * emscripten_get_now(); } // s

std::string taken(char* text)
{
    const std::unique_ptr<char, void (*)(void*)> owned(text, std::free);
    return text ? text : "";
}

template <class Event> Modifiers modifiers_of(const Event& event)
{
    return {.ctrl = event.ctrlKey || event.metaKey, .shift = event.shiftKey != 0, .alt = event.altKey != 0};
}

std::optional<PointerButton> button_of(unsigned short button)
{
    constexpr std::array<PointerButton, n_pointer_buttons> of_browser = {PointerButton::Left, PointerButton::Middle,
                                                                         PointerButton::Right};
    return button < of_browser.size() ? std::optional(of_browser[button]) : std::nullopt;
}

/// Notches of a wheel, from what browsers tell in pixels, lines or pages.
double notches(double delta, unsigned long mode)
{
    constexpr double pixels = 100.0, lines = 3.0;
    if (mode == DOM_DELTA_PIXEL) return delta / pixels;
    return mode == DOM_DELTA_LINE ? delta / lines : delta;
}

constexpr std::array<const char*, 6> cursors = {"default", "text", "pointer", "crosshair", "ew-resize", "ns-resize"};

} // namespace

struct Window::Parts {
    std::unique_ptr<gl::Functions> gl;
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;
    PointerShape shape = PointerShape::Arrow;
    Input input;
    Typing typing;
    ButtonEvents buttons;
    TouchGesture touch;
    double time = now(); ///< of the last frame's input [s]
    bool has_news = true;

    Parts() { open(); }
    ~Parts() { emscripten_webgl_destroy_context(context); }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    void open();
    void listen();
    void listen_to_touch();
    void follow(const EmscriptenTouchEvent& event, bool is_end);
    void press(PointerButton button, bool is_down, Point place, Modifiers modifiers);
    bool type(const EmscriptenKeyboardEvent& event, bool is_down);
    void fit_canvas() const;
    void collect_files();

    static Parts& of(void* user)
    {
        auto& parts = *static_cast<Parts*>(user);
        parts.has_news = true;
        return parts;
    }
};

void Window::Parts::open()
{
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.alpha = wanted.depth = wanted.stencil = wanted.antialias = false;
    context = emscripten_webgl_create_context(canvas, &wanted);
    if (context <= 0) throw ContextError("this browser has no WebGL 2, or it is switched off");
    emscripten_webgl_make_context_current(context);
    gl = std::make_unique<gl::Functions>(
        [](const char* name) { return reinterpret_cast<gl::Proc>(emscripten_webgl_get_proc_address(name)); });
    fit_canvas();
    listen();
    listen_to_touch();
    web_listen_to_clipboard();
}

void Window::Parts::press(PointerButton button, bool is_down, Point place, Modifiers modifiers)
{
    input.modifiers = modifiers;
    input.pointer = place;
    buttons.add({button, is_down, place, modifiers, now(), now()});
}

namespace {

Point place_of(const EmscriptenMouseEvent& event)
{
    return {static_cast<double>(event.clientX) - web_canvas_left(),
            static_cast<double>(event.clientY) - web_canvas_top()};
}

/// Within the canvas: others' fields take part of a touch, too.
Point place_of(const EmscriptenTouchPoint& touch)
{
    return {static_cast<double>(touch.clientX) - web_canvas_left(),
            static_cast<double>(touch.clientY) - web_canvas_top()};
}

} // namespace

// The pointer is followed beyond the canvas, so that a drag goes on there.
void Window::Parts::listen()
{
    const auto on_move = [](int, const EmscriptenMouseEvent* event, void* user) -> EM_BOOL {
        of(user).input.pointer = place_of(*event);
        return EM_FALSE;
    };
    const auto on_down = [](int, const EmscriptenMouseEvent* event, void* user) -> EM_BOOL {
        if (const auto button = button_of(event->button))
            of(user).press(*button, true, place_of(*event), modifiers_of(*event));
        return EM_FALSE; // so that the canvas gets the keyboard
    };
    const auto on_up = [](int, const EmscriptenMouseEvent* event, void* user) -> EM_BOOL {
        if (const auto button = button_of(event->button))
            of(user).press(*button, false, place_of(*event), modifiers_of(*event));
        return EM_FALSE;
    };
    const auto on_leave = [](int, const EmscriptenMouseEvent* event, void* user) -> EM_BOOL {
        if (event->buttons == 0) of(user).input.pointer.reset();
        return EM_FALSE;
    };
    const auto on_wheel = [](int, const EmscriptenWheelEvent* event, void* user) -> EM_BOOL {
        Point& wheel = of(user).input.wheel;
        wheel = wheel - Point{notches(event->deltaX, event->deltaMode), notches(event->deltaY, event->deltaMode)};
        return EM_TRUE;
    };
    const auto on_key_down = [](int, const EmscriptenKeyboardEvent* event, void* user) -> EM_BOOL {
        return of(user).type(*event, true);
    };
    const auto on_key_up = [](int, const EmscriptenKeyboardEvent* event, void* user) -> EM_BOOL {
        return of(user).type(*event, false);
    };
    const auto on_blur = [](int, const EmscriptenFocusEvent*, void* user) -> EM_BOOL {
        of(user).input.has_lost_focus = true;
        return EM_FALSE;
    };
    emscripten_set_mousedown_callback(canvas, this, false, on_down);
    emscripten_set_mouseup_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, false, on_up);
    emscripten_set_mousemove_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, false, on_move);
    emscripten_set_mouseleave_callback(canvas, this, false, on_leave);
    emscripten_set_wheel_callback(canvas, this, false, on_wheel);
    emscripten_set_keydown_callback(canvas, this, false, on_key_down);
    emscripten_set_keyup_callback(canvas, this, false, on_key_up);
    emscripten_set_blur_callback(canvas, this, false, on_blur);
}

// An end names the fingers that have left too.
void Window::Parts::follow(const EmscriptenTouchEvent& event, bool is_end)
{
    std::vector<Point> fingers;
    for (const EmscriptenTouchPoint& finger : std::span(event.touches, static_cast<std::size_t>(event.numTouches)))
        if (!(is_end && finger.isChanged)) fingers.push_back(place_of(finger));
    touch.follow(fingers, now(), buttons, input);
}

void Window::Parts::listen_to_touch()
{
    const auto on_touch = [](int, const EmscriptenTouchEvent* event, void* user) -> EM_BOOL {
        of(user).follow(*event, false);
        return EM_TRUE;
    };
    const auto on_end = [](int, const EmscriptenTouchEvent* event, void* user) -> EM_BOOL {
        of(user).follow(*event, true);
        return EM_TRUE;
    };
    emscripten_set_touchstart_callback(canvas, this, false, on_touch);
    emscripten_set_touchmove_callback(canvas, this, false, on_touch);
    emscripten_set_touchend_callback(canvas, this, false, on_end);
    emscripten_set_touchcancel_callback(canvas, this, false, on_end);
}

/// \returns whether the browser is to do nothing else with it
bool Window::Parts::type(const EmscriptenKeyboardEvent& event, bool is_down)
{
    input.modifiers = modifiers_of(event);
    if (is_of_browser(event.key, input.modifiers)) return false;
    const auto key = key_named(event.key);
    if (key && !(is_down && event.repeat)) typing.add(KeyEvent{*key, is_down, input.modifiers}); // widgets repeat keys
    const bool is_alt_graph = event.ctrlKey && event.altKey;
    const bool is_plain = !input.modifiers.ctrl && !input.modifiers.alt;
    if (is_down && is_one_character(event.key) && (is_plain || is_alt_graph)) typing.add(event.key);
    return !is_for_clipboard(event.key, input.modifiers);
}

// As many pixels as the screen shows in its place.
void Window::Parts::fit_canvas() const
{
    double width = 0.0, height = 0.0;
    emscripten_get_element_css_size(canvas, &width, &height);
    const double scale = emscripten_get_device_pixel_ratio();
    const PixelSize wanted{static_cast<int>(std::lround(scale * width)), static_cast<int>(std::lround(scale * height))};
    PixelSize size;
    emscripten_get_canvas_element_size(canvas, &size.width, &size.height);
    if (size != wanted) emscripten_set_canvas_element_size(canvas, wanted.width, wanted.height);
}

void Window::Parts::collect_files()
{
    for (char* path = web_next_file(); path != nullptr; path = web_next_file()) {
        input.dropped_files.push_back(taken(path));
        has_news = true;
    }
}

Window::Window(const Setup&) : parts_(std::make_unique<Parts>()) {}
Window::~Window() = default;

void Window::make_current()
{
    emscripten_webgl_make_context_current(parts_->context);
    parts_->gl->BindFramebuffer(gl::framebuffer, 0);
}

PixelSize Window::size() const
{
    PixelSize size;
    emscripten_get_canvas_element_size(canvas, &size.width, &size.height);
    return size;
}

double Window::scale() const { return emscripten_get_device_pixel_ratio(); }
const gl::Functions& Window::gl() const { return *parts_->gl; }
void Window::present() // the browser does when the frame is over
{
    web_tell_whether_text_is_wanted(ImGui::GetCurrentContext() != nullptr && ImGui::GetIO().WantTextInput);
}
bool Window::wants_to_close() const { return false; } // the page asks before it is left (page.js)
void Window::stay_open() {}
void Window::close() {}
void Window::set_title(const std::string& title) { web_set_title(title.c_str()); }

void Window::set_pointer(PointerShape shape)
{
    if (std::exchange(parts_->shape, shape) != shape) web_set_cursor(cursors[static_cast<std::size_t>(shape)]);
}

std::string Window::clipboard() const { return taken(web_clipboard()); }
void Window::set_clipboard(const std::string& text) { web_set_clipboard(text.c_str()); }

bool Window::wait(double patience)
{
    parts_->collect_files();
    if (parts_->touch.tick(now(), parts_->buttons)) parts_->has_news = true;
    const PixelSize before = size();
    parts_->fit_canvas();
    return patience <= 0.0 || parts_->has_news || size() != before || now() - parts_->time >= patience;
}

Input Window::input()
{
    constexpr double shortest = 1e-3; // two frames may come within one tick of the browser's clock
    Input current = parts_->input;
    const double time = now();
    current.seconds = std::max(shortest, time - std::exchange(parts_->time, time));
    parts_->buttons.deliver_next(current);
    parts_->has_news = false;
    Input& next = parts_->input;
    next.wheel = {};
    next.dropped_files.clear();
    next.has_lost_focus = false;
    return current;
}

Typing& Window::typing() { return parts_->typing; }

bool Window::has_display() { return web_has_page() != 0; }

} // namespace ui
