#include "ui/context/window.h"

#include "ui/context/button_events.h"
#include "ui/context/room_to_draw.h"
#include "ui/paint/text_measure.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace ui {

namespace {

std::string last_window_error()
{
    const char* words = nullptr;
    glfwGetError(&words);
    return words ? words : "no reason given";
}

/// GLFW while anyone uses it.
class Glfw {
public:
    Glfw()
    {
        require_room_to_draw();
        if (!glfwInit())
            throw ContextError("no window can be opened: " + last_window_error() +
                               "; on a machine without a display use `cremona render` or `--screenshot`");
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

constexpr std::pair<int, Key> named_keys[] = {
    {GLFW_KEY_ESCAPE, Key::Escape}, {GLFW_KEY_ENTER, Key::Enter},      {GLFW_KEY_KP_ENTER, Key::Enter},
    {GLFW_KEY_TAB, Key::Tab},       {GLFW_KEY_SPACE, Key::Space},      {GLFW_KEY_BACKSPACE, Key::Backspace},
    {GLFW_KEY_DELETE, Key::Delete}, {GLFW_KEY_LEFT, Key::Left},        {GLFW_KEY_RIGHT, Key::Right},
    {GLFW_KEY_UP, Key::Up},         {GLFW_KEY_DOWN, Key::Down},        {GLFW_KEY_HOME, Key::Home},
    {GLFW_KEY_END, Key::End},       {GLFW_KEY_PAGE_UP, Key::PageUp},   {GLFW_KEY_PAGE_DOWN, Key::PageDown},
    {GLFW_KEY_KP_ADD, Key::Plus},   {GLFW_KEY_KP_SUBTRACT, Key::Minus}};

Key counted(Key first, int offset) { return static_cast<Key>(static_cast<int>(first) + offset); }

/// By what the key writes on this keyboard, so that Ctrl+Z is where the Z is.
std::optional<Key> key_written(int key, int scancode)
{
    const char* written = glfwGetKeyName(key, scancode);
    if (!written || written[0] == '\0' || written[1] != '\0') return std::nullopt;
    const char c = written[0];
    if (c >= 'a' && c <= 'z') return counted(Key::A, c - 'a');
    if (c >= 'A' && c <= 'Z') return counted(Key::A, c - 'A');
    if (c >= '0' && c <= '9') return counted(Key::Digit0, c - '0');
    if (c == '+' || c == '=') return Key::Plus;
    if (c == '-') return Key::Minus;
    return std::nullopt;
}

std::optional<Key> key_of(int key, int scancode)
{
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return counted(Key::F1, key - GLFW_KEY_F1);
    for (const auto& [theirs, ours] : named_keys)
        if (theirs == key) return ours;
    return key_written(key, scancode);
}

Modifiers modifiers_of(int mods)
{
    const bool is_ctrl = (mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0;
    return {.ctrl = is_ctrl, .shift = (mods & GLFW_MOD_SHIFT) != 0, .alt = (mods & GLFW_MOD_ALT) != 0};
}

// On X11 a modifier's own key comes with the modifiers as they were before it.
Modifiers modifiers_after(int key, int action, int mods)
{
    Modifiers held = modifiers_of(mods);
    const bool is_down = action != GLFW_RELEASE;
    switch (key) {
    case GLFW_KEY_LEFT_CONTROL:
    case GLFW_KEY_RIGHT_CONTROL:
    case GLFW_KEY_LEFT_SUPER:
    case GLFW_KEY_RIGHT_SUPER: held.ctrl = is_down; break;
    case GLFW_KEY_LEFT_SHIFT:
    case GLFW_KEY_RIGHT_SHIFT: held.shift = is_down; break;
    case GLFW_KEY_LEFT_ALT:
    case GLFW_KEY_RIGHT_ALT: held.alt = is_down; break;
    default: break;
    }
    return held;
}

constexpr std::array<int, 6> cursor_shapes = {GLFW_ARROW_CURSOR,     GLFW_IBEAM_CURSOR,   GLFW_HAND_CURSOR,
                                              GLFW_CROSSHAIR_CURSOR, GLFW_HRESIZE_CURSOR, GLFW_VRESIZE_CURSOR};

std::string utf8(unsigned codepoint)
{
    const char32_t character = codepoint;
    return encode_utf8({&character, 1});
}

} // namespace

struct Window::Parts {
    Glfw glfw;
    GLFWwindow* window = nullptr;
    std::unique_ptr<gl::Functions> gl;
    std::array<GLFWcursor*, cursor_shapes.size()> cursors{};
    Input input;
    Typing typing;
    ButtonEvents buttons;
    std::optional<Point> heard_at; ///< where the pointer was, as of the events heard so far [GLFW's units]
    double time = 0.0;             ///< of the last frame's input [s]
    double listens_since = 0.0;    ///< [s]

    explicit Parts(const Setup& setup) { open(setup); }
    ~Parts()
    {
        for (GLFWcursor* cursor : cursors)
            if (cursor) glfwDestroyCursor(cursor);
        if (window) glfwDestroyWindow(window);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    void open(const Setup& setup);
    void listen();
    double content_scale() const;
    /// Physical pixels of a unit of GLFW's window coordinates.
    double pixels_per_unit() const;
    Point pointer() const; ///< where it is now [logical pixels]
    Point place_of_event() const;
    Point in_logical_pixels(Point place) const { return (pixels_per_unit() / content_scale()) * place; }
    double earliest_time() const;

    static Parts& of(GLFWwindow* window) { return *static_cast<Parts*>(glfwGetWindowUserPointer(window)); }
};

namespace {

// No larger than the screen: it may have been a larger one the last time.
Size on_screen(Size wanted)
{
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return wanted;
    int x = 0, y = 0, width = 0, height = 0;
    glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
    float scale_x = 1.0F, scale_y = 1.0F;
    glfwGetMonitorContentScale(monitor, &scale_x, &scale_y);
    if (width <= 0 || height <= 0 || scale_x <= 0.0F || scale_y <= 0.0F) return wanted;
    return {std::min(wanted.width, width / static_cast<double>(scale_x)),
            std::min(wanted.height, height / static_cast<double>(scale_y))};
}

} // namespace

void Window::Parts::open(const Setup& setup)
{
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    const Size size = on_screen(setup.size);
    window = glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height), setup.title.c_str(), nullptr,
                              nullptr);
    if (!window) throw ContextError("no window with OpenGL 3.3 can be opened: " + last_window_error());
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    gl = std::make_unique<gl::Functions>(glfwGetProcAddress);
    glfwSetWindowUserPointer(window, this);
    listen();
    time = glfwGetTime();
}

void Window::Parts::listen()
{
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        Input& heard = of(w).input;
        heard.wheel = heard.wheel + Point{x, y};
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { of(w).heard_at = Point{x, y}; });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
        if (button < 0 || button >= static_cast<int>(n_pointer_buttons)) return;
        Parts& parts = of(w);
        parts.input.modifiers = modifiers_of(mods);
        parts.buttons.add({static_cast<PointerButton>(button), action == GLFW_PRESS, parts.place_of_event(),
                           modifiers_of(mods), parts.earliest_time(), glfwGetTime()});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        Parts& parts = of(w);
        parts.input.modifiers = modifiers_after(key, action, mods);
        if (action == GLFW_REPEAT) return; // the widgets repeat keys by themselves
        const auto known = key_of(key, scancode);
        if (known) parts.typing.add(KeyEvent{*known, action == GLFW_PRESS, parts.input.modifiers});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned codepoint) { of(w).typing.add(utf8(codepoint)); });
    glfwSetDropCallback(window, [](GLFWwindow* w, int n, const char** paths) {
        for (int i = 0; i < n; ++i) of(w).input.dropped_files.emplace_back(paths[i]);
    });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int has_focus) {
        if (!has_focus) of(w).input.has_lost_focus = true;
    });
}

double Window::Parts::content_scale() const
{
    float x = 1.0F, y = 1.0F;
    glfwGetWindowContentScale(window, &x, &y);
    return x > 0.0F ? static_cast<double>(x) : 1.0;
}

double Window::Parts::pixels_per_unit() const
{
    int width = 0, height = 0, pixels_wide = 0, pixels_high = 0;
    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &pixels_wide, &pixels_high);
    return width > 0 ? static_cast<double>(pixels_wide) / width : 1.0;
}

Point Window::Parts::pointer() const
{
    Point place;
    glfwGetCursorPos(window, &place.x, &place.y);
    return in_logical_pixels(place);
}

// By the motion that was heard before it: while a frame is drawn the pointer goes on, and is elsewhere by now.
Point Window::Parts::place_of_event() const { return heard_at ? in_logical_pixels(*heard_at) : pointer(); }

// Of what is heard now: it has just come where it was waited for, else at any time since the frame before.
double Window::Parts::earliest_time() const
{
    constexpr double at_once = 0.005;
    const double now = glfwGetTime();
    return now - listens_since > at_once ? now : time;
}

Window::Window(const Setup& setup) : parts_(std::make_unique<Parts>(setup)) {}
Window::~Window() = default;

void Window::make_current()
{
    // Released first: an off-screen context may have been made current behind the back of the window system, which
    // would then take this window's for current still and do nothing.
    glfwMakeContextCurrent(nullptr);
    glfwMakeContextCurrent(parts_->window);
    parts_->gl->BindFramebuffer(gl::framebuffer, 0);
}

PixelSize Window::size() const
{
    PixelSize size;
    glfwGetFramebufferSize(parts_->window, &size.width, &size.height);
    return size;
}

double Window::scale() const { return parts_->content_scale(); }
const gl::Functions& Window::gl() const { return *parts_->gl; }
void Window::present() { glfwSwapBuffers(parts_->window); }
bool Window::wants_to_close() const { return glfwWindowShouldClose(parts_->window) != 0; }
void Window::stay_open() { glfwSetWindowShouldClose(parts_->window, GLFW_FALSE); }
void Window::close() { glfwSetWindowShouldClose(parts_->window, GLFW_TRUE); }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(parts_->window, title.c_str()); }

void Window::set_pointer(PointerShape shape)
{
    const auto i = static_cast<std::size_t>(shape);
    if (!parts_->cursors[i]) parts_->cursors[i] = glfwCreateStandardCursor(cursor_shapes[i]);
    glfwSetCursor(parts_->window, parts_->cursors[i]);
}

std::string Window::clipboard() const
{
    const char* text = glfwGetClipboardString(parts_->window);
    return text ? text : "";
}

void Window::set_clipboard(const std::string& text) { glfwSetClipboardString(parts_->window, text.c_str()); }

bool Window::wait(double patience)
{
    parts_->listens_since = glfwGetTime();
    if (patience > 0.0) glfwWaitEventsTimeout(patience);
    else glfwPollEvents();
    return true;
}

Input Window::input()
{
    Input now = parts_->input;
    const double time = glfwGetTime();
    now.seconds = time - std::exchange(parts_->time, time);
    parts_->buttons.deliver_next(now);
    const bool is_held = std::ranges::any_of(now.is_button_down, [](bool is_down) { return is_down; });
    if (!now.pointer && (is_held || glfwGetWindowAttrib(parts_->window, GLFW_HOVERED))) now.pointer = parts_->pointer();
    Input& next = parts_->input;
    next.wheel = {};
    next.dropped_files.clear();
    next.has_lost_focus = false;
    return now;
}

Typing& Window::typing() { return parts_->typing; }

bool Window::has_display()
{
    if (!glfwInit()) return false;
    glfwTerminate();
    return true;
}

} // namespace ui
