#pragma once

#include "tests/golden/scene.h"
#include "ui/context/imgui_session.h"
#include "ui/context/offscreen.h"

#include <imgui.h>

namespace ui_test {

/// A session on a small off-screen picture with one window in it, for tests to play with.
struct WidgetStage {
    explicit WidgetStage(double scale)
        : context({.size = {static_cast<int>(300 * scale), static_cast<int>(200 * scale)}, .scale = scale}),
          session(context, fonts, ui::Theme(ui::ThemeName::Light))
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

inline bool has_renderer()
{
    const ui::Fonts fonts;
    return golden::drawn(ui::Picture({4.0, 4.0}), fonts, {.size = {4.0, 4.0}}).has_value();
}

} // namespace ui_test
