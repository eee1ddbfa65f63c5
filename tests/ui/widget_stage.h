#pragma once

#include "tests/golden/scene.h"
#include "ui/context/imgui_session.h"
#include "ui/context/offscreen.h"

#include <imgui.h>

#include <string>

namespace ui_test {

/// A session on a small off-screen picture with one window in it, for tests to play with.
struct WidgetStage {
    explicit WidgetStage(double scale, ui::ThemeName theme = ui::ThemeName::Light)
        : context({.size = {static_cast<int>(300 * scale), static_cast<int>(200 * scale)}, .scale = scale}),
          session(context, fonts, ui::Theme(theme))
    {}

    /// One frame in which `widgets` stand in a window that fills the picture.
    template <class Widgets> void frame(const ui::Input& input, const Widgets& widgets)
    {
        session.begin_frame(input);
        ImGui::SetNextWindowPos({0.0F, 0.0F});
        ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
        widgets();
        ImGui::End();
        session.end_frame();
    }

    ui::Fonts fonts;
    ui::Offscreen context;
    ui::ImGuiSession session;
};

/// A hand at what a test shows frame by frame: what it does takes some of them.
struct Hand {
    virtual ~Hand() = default;
    virtual void frame(const ui::Input& input) = 0;

    void rest()
    {
        for (int i = 0; i < 3; ++i) frame({});
    }
    void key(ui::Key key)
    {
        frame({.keys = {{key, true}}});
        frame({.keys = {{key, false}}});
        rest();
    }
    void type(const std::string& text)
    {
        frame({.text = text});
        rest();
    }
};

inline bool has_renderer()
{
    const ui::Fonts fonts;
    return golden::drawn(ui::Picture({4.0, 4.0}), fonts, {.size = {4.0, 4.0}}).has_value();
}

} // namespace ui_test
