#pragma once

#include "ui/context/context.h"
#include "ui/context/draw_list_renderer.h"
#include "ui/context/input.h"
#include "ui/context/typing.h"
#include "ui/paint/geometry.h"
#include "ui/paint/picture.h"
#include "ui/paint/surface/glyph_atlas.h"
#include "ui/paint/theme.h"

#include <functional>
#include <string>

struct ImDrawList;
struct ImFont;
struct ImGuiContext;

namespace ui {

/// Dear ImGui on a context, on the screen or off it: the frame's beginning and end, its type, its colours, its input.
///
///     while (!window.wants_to_close()) {
///         window.wait(patience);
///         Input input = window.input();
///         if (!session.awaits_field()) window.typing().deliver_next(input, session.reader());
///         session.begin_frame(input);
///         ... widgets, session.show(picture, *ImGui::GetBackgroundDrawList(), {})
///         session.end_frame();
///         window.present();
///     }
///
/// Dear ImGui's unit is a physical pixel here: multiply lengths by `scale()`. It saves nothing to disk.
class ImGuiSession {
public:
    /// How the system's clipboard is reached; without it copied text stays in the program.
    struct Clipboard {
        std::function<std::string()> text;
        std::function<void(const std::string&)> set_text;
    };

    /// \pre the context and the fonts outlive the session
    ImGuiSession(Context& context, const Fonts& fonts, const Theme& theme);
    ~ImGuiSession();
    ImGuiSession(const ImGuiSession&) = delete;
    ImGuiSession& operator=(const ImGuiSession&) = delete;

    /// Takes effect at the next frame.
    void set_theme(const Theme& theme);
    void set_clipboard(Clipboard clipboard) { clipboard_ = std::move(clipboard); }

    /// \param keeps_panels_still  the arrows and the space bar are pressed for a command, and do nothing in panels
    void begin_frame(const Input& input, bool keeps_panels_still = false);
    /// Has a widget the keyboard, framed so that one sees it?
    bool is_widget_framed() const;
    void unframe_widget(); ///< until a key moves on from it
    /// Draws the frame over the theme's background; `present` the context afterwards.
    void end_frame();

    /// Draws a picture on a list of this session's; its top left corner lies at `corner` [physical pixels].
    void show(const Picture& picture, ImDrawList& list, Point corner);

    /// A field asked in the last frame for the keyboard and has it at the end of the next one: what is typed until then
    /// would be lost.
    bool awaits_field() const { return awaits_field_; }
    /// Text of the last frame that came too early for that field.
    const std::string& unread_text() const { return unread_text_; }
    Typing::Reader reader() const;

    /// Physical pixels of a logical one: the context's, but less in a small window on the projector, which then shows
    /// what a larger one shows. The last row sees the share of the window's height, which stays the same.
    double scale() const { return scale_; }
    /// A place of the session [logical pixels], in those of the context, as `Input` has the pointer.
    Point in_window(Point place) const { return (scale_ / context_.scale()) * place; }
    ImFont* regular() const { return regular_; }
    ImFont* bold() const { return bold_; }
    ImFont* large() const { return large_; }

private:
    double wanted_scale() const;
    void load_type();
    void set_style();
    void feed(const Input& input);
    void feed_keys(const std::vector<KeyEvent>& events);
    Key meant(const KeyEvent& event);
    void look_for_field();

    Context& context_;
    const Fonts& fonts_;
    Theme theme_;
    double scale_;
    bool is_stale_ = false; ///< type and style do not fit the theme or the scale
    std::vector<KeyEvent> waiting_keys_;
    bool is_enter_space_ = false; ///< since it went down in a menu
    bool awaits_field_ = false;
    std::string unread_text_;
    ImGuiContext* imgui_;
    DrawListRenderer renderer_;
    GlyphAtlas atlas_;
    Image type_image_;
    ImFont* regular_ = nullptr;
    ImFont* bold_ = nullptr;
    ImFont* large_ = nullptr;
    Clipboard clipboard_;
    std::string copied_;
};

} // namespace ui
