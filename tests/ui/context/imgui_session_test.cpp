#include "ui/context/imgui_session.h"

#include "tests/ui/widget_stage.h"
#include "ui/paint/painter.h"

#include <doctest/doctest.h>

#include <imgui.h>

using ui_test::has_renderer;
using Stage = ui_test::WidgetStage;

namespace {

/// How often a button is clicked by a press and a release where it is drawn.
int clicks_where_drawn(Stage& stage)
{
    ui::Point middle;
    int n_clicks = 0;
    const auto button = [&] {
        if (ImGui::Button("Solve")) ++n_clicks;
        const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
        const ui::Point sum{static_cast<double>(a.x + b.x), static_cast<double>(a.y + b.y)};
        middle = stage.session.in_window(sum / (2.0 * stage.session.scale()));
    };
    stage.frame({}, button);
    stage.frame({}, button);
    ui::Input hover{.pointer = middle}, press = hover;
    press.is_button_down[0] = true;
    stage.frame(hover, button);
    stage.frame(press, button);
    stage.frame(hover, button);
    return n_clicks;
}

} // namespace

TEST_SUITE_BEGIN("widgets off screen");

TEST_CASE("A press and a release over a button click it, at every scale")
{
    if (!has_renderer()) return;
    for (const double scale : {1.0, 2.0}) {
        CAPTURE(scale);
        Stage stage(scale);
        CHECK(stage.session.scale() == scale);
        CHECK(clicks_where_drawn(stage) == 1);
    }
}

TEST_CASE("A small window on the projector is drawn smaller, and is pressed where it is drawn")
{
    if (!has_renderer()) return;
    for (const double scale : {1.0, 2.0}) {
        CAPTURE(scale);
        Stage stage(scale, ui::ThemeName::Projector);
        CHECK(stage.session.scale() == doctest::Approx(0.65 * scale));
        CHECK(clicks_where_drawn(stage) == 1);
    }
}

TEST_CASE("A window with room keeps the projector's type, and a theme of the desk any window's")
{
    if (!has_renderer()) return;
    const ui::Fonts fonts;
    const auto scale = [&](ui::PixelSize size, ui::ThemeName theme) {
        ui::Offscreen context({.size = size, .scale = 1.0});
        return ui::ImGuiSession(context, fonts, ui::Theme(theme)).scale();
    };
    CHECK(scale({1280, 800}, ui::ThemeName::Projector) == 1.0);
    CHECK(scale({1920, 1080}, ui::ThemeName::Projector) == 1.0);
    CHECK(scale({900, 540}, ui::ThemeName::Projector) == doctest::Approx(0.75));
    CHECK(scale({900, 540}, ui::ThemeName::Light) == 1.0);
}

TEST_CASE("Two presses are a double click by the hand's time, however late the frames are")
{
    if (!has_renderer()) return;
    const auto is_double = [](double frame, std::optional<double> since_press) {
        Stage stage(1.0);
        bool is_seen = false;
        const auto look = [&] { is_seen = is_seen || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left); };
        const ui::Input rest{.pointer = ui::Point{31.0, 17.0}, .seconds = frame};
        ui::Input press = rest, second = rest;
        press.is_button_down[0] = second.is_button_down[0] = true;
        second.since_press = since_press;
        for (const ui::Input& input : {rest, press, rest, second, rest}) stage.frame(input, look);
        return is_seen;
    };
    CHECK(is_double(0.2, std::nullopt));
    CHECK_FALSE(is_double(0.3, std::nullopt));
    CHECK(is_double(0.3, 0.45));
    CHECK(is_double(2.0, 0.1));
    CHECK_FALSE(is_double(0.01, 0.55));
}

TEST_CASE("A sign that the font lacks is no question mark in a panel")
{
    if (!has_renderer()) return;
    Stage stage(1.0);
    stage.frame({}, [] {
        const ImFont& font = *ImGui::GetFont();
        CHECK(font.FindGlyph(0x4E2D)->Codepoint == 0xFFFD); // a Chinese one
        CHECK(font.FindGlyphNoFallback(0x2300) != nullptr); // a diameter
        CHECK(font.FindGlyph('?')->Codepoint == '?');
    });
}

TEST_CASE("Typed letters and a key that goes down and up in one frame reach a text field")
{
    if (!has_renderer()) return;
    Stage stage(1.0);
    char text[32] = "";
    bool is_entered = false;
    const auto field = [&] {
        ImGui::SetKeyboardFocusHere();
        is_entered = ImGui::InputText("##name", text, sizeof text, ImGuiInputTextFlags_EnterReturnsTrue) || is_entered;
    };
    stage.frame({}, field);
    stage.frame({}, field);
    stage.frame({.text = "vão 2"}, field);
    stage.frame({}, field);
    CHECK(std::string(text) == "vão 2");
    const auto enter = [&] {
        is_entered = ImGui::InputText("##name", text, sizeof text, ImGuiInputTextFlags_EnterReturnsTrue) || is_entered;
    };
    stage.frame({.keys = {{ui::Key::Enter, true}, {ui::Key::Enter, false}}}, enter);
    stage.frame({}, enter);
    CHECK(is_entered);
}

TEST_CASE("A picture shown in a window lies where it was put, under the widgets")
{
    if (!has_renderer()) return;
    Stage stage(2.0);
    ui::Painter painter({20.0, 10.0}, stage.fonts);
    painter.rectangle(painter.sheet(), ui::rgb(0x0072B2));
    stage.session.begin_frame({});
    stage.session.show(painter.picture(), *ImGui::GetBackgroundDrawList(), {100.0, 60.0});
    stage.session.end_frame();
    const ui::Pixels pixels = stage.context.pixels();
    CHECK(pixels.at(120, 70)[2] == 0xB2);
    CHECK(pixels.at(139, 79)[2] == 0xB2);
    CHECK(pixels.at(141, 70)[2] == 0xFF);
    CHECK(pixels.at(99, 70)[2] == 0xFF);
}

TEST_CASE("Another theme takes effect at the next frame")
{
    if (!has_renderer()) return;
    Stage stage(1.0);
    const ui::Theme dark(ui::ThemeName::Dark);
    stage.session.set_theme(dark);
    stage.session.begin_frame({});
    stage.session.end_frame();
    CHECK(stage.context.pixels().at(5, 5)[0] == dark.background().r);
}

TEST_CASE("Two sessions do not disturb one another")
{
    if (!has_renderer()) return;
    Stage first(1.0), second(1.0);
    int n_first = 0, n_second = 0;
    first.frame({}, [&] { n_first = ImGui::GetFrameCount(); });
    first.frame({}, [&] { n_first = ImGui::GetFrameCount(); });
    second.frame({}, [&] { n_second = ImGui::GetFrameCount(); });
    CHECK(n_first == 2);
    CHECK(n_second == 1);
}

TEST_SUITE_END();
