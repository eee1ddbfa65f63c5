#include "ui/context/offscreen.h"

#include "tests/golden/comparison.h"
#include "tests/golden/scene.h"
#include "ui/context/draw_list_renderer.h"
#include "ui/context/paint_to_png.h"
#include "ui/context/rasterize.h"
#include "ui/context/window.h"
#include "ui/context/write_picture.h"
#include "ui/paint/painter.h"
#include "ui/text/catalogue.h"

#include <doctest/doctest.h>
#include <imgui.h>

#include <array>
#include <optional>

using doctest::Approx;

namespace {

constexpr ui::Color black = ui::rgb(0x000000);

/// The box of the pixels that are darker than half.
ui::Box ink_box(const ui::Pixels& pixels)
{
    ui::Box box{{1e9, 1e9}, {-1e9, -1e9}};
    for (int y = 0; y < pixels.size.height; ++y)
        for (int x = 0; x < pixels.size.width; ++x)
            if (pixels.at(x, y)[0] < 128)
                box = ui::united(box, {{static_cast<double>(x), static_cast<double>(y)}, {x + 1.0, y + 1.0}});
    return box;
}

/// The drawing at that scale; nothing where there is no renderer, which is said.
std::optional<ui::Pixels> pixels_of(const ui::Drawing& drawing, double scale = 1.0)
{
    const ui::Fonts fonts;
    const ui::Sheet sheet{.size = {200.0, 100.0}, .scale = scale};
    return golden::drawn(ui::painted(sheet, fonts, drawing), fonts, sheet);
}

void fill(ui::DrawListRenderer& renderer, ui::Color color)
{
    ImDrawData nothing;
    nothing.DisplaySize = {1.0F, 1.0F};
    renderer.render(nothing, color);
}

} // namespace

TEST_SUITE_BEGIN("off screen");

TEST_CASE("A level line of odd width covers whole pixels and not a shade beside them")
{
    const auto pixels = pixels_of([](ui::Painter& p) {
        p.line({20.2, 50.4}, {180.7, 50.4}, {.color = black, .width = 3.0});
    });
    if (!pixels) return;
    for (int y = 40; y < 60; ++y) {
        CAPTURE(y);
        CHECK(pixels->at(100, y)[0] == (y >= 49 && y <= 51 ? 0 : 255));
    }
}

TEST_CASE("The last bit of a place between two pixels does not move a line")
{
    for (const double width : {1.0, 2.0}) {
        CAPTURE(width);
        const double between = width == 1.0 ? 100.0 : 100.5;
        const auto drawn_at = [&](double x) {
            return pixels_of([&](ui::Painter& p) { p.line({x, 10.0}, {x, 90.0}, {.color = black, .width = width}); });
        };
        const auto below = drawn_at(between - 1e-11), above = drawn_at(between + 1e-11);
        if (!below || !above) return;
        CHECK(ink_box(*below).min.x == ink_box(*above).min.x);
    }
}

TEST_CASE("At scale two a line is twice as thick in pixels")
{
    const auto pixels = pixels_of(
        [](ui::Painter& p) {
            p.line({100.0, 10.0}, {100.0, 90.0}, {.color = black, .width = 3.0});
        },
        2.0);
    if (!pixels) return;
    CHECK(pixels->size == ui::PixelSize{400, 200});
    CHECK(ink_box(*pixels).width() == 6.0);
}

TEST_CASE("Drawn text takes the room that was measured, to a pixel")
{
    const ui::Fonts fonts;
    for (const double rotation : {0.0, 1.5707963267948966}) {
        CAPTURE(rotation);
        const ui::TextStyle style{.color = black, .size = 22.0, .anchor = ui::Anchor::Center, .rotation = rotation};
        const auto pixels = pixels_of([&](ui::Painter& p) { p.text({100.0, 50.0}, "HH88H", style); });
        if (!pixels) return;
        const ui::Box ink = ink_box(*pixels);
        // H has side bearings of 201 of 2048 units, and its height is that of a capital
        const double width = fonts.measure("HH88H", style).width - 2.0 * 201.0 / 2048.0 * 22.0;
        CHECK(std::abs((rotation == 0.0 ? ink.width() : ink.height()) - width) <= 1.5);
        CHECK(std::abs((rotation == 0.0 ? ink.height() : ink.width()) - fonts.cap_height() * 22.0) <= 1.5);
        CHECK(ui::distance(ink.center(), {100.0, 50.0}) <= 1.5);
    }
}

TEST_CASE("Type larger than the atlas draws is stretched to its size")
{
    const ui::Fonts fonts;
    const auto pixels = pixels_of(
        [&](ui::Painter& p) {
            p.text({100.0, 50.0}, "-", {.color = black, .size = 300.0, .anchor = ui::Anchor::Center});
        },
        3.0);
    if (!pixels) return;
    // the hyphen's ink runs from 100 to 639 of 2048 units
    CHECK(ink_box(*pixels).width() == Approx(539.0 / 2048.0 * 900.0).epsilon(0.03));
}

TEST_CASE("Nothing is drawn outside a clip")
{
    const auto pixels = pixels_of([](ui::Painter& p) {
        const ui::ClipScope clip(p, {{50.0, 20.0}, {150.0, 80.0}});
        p.rectangle(p.sheet(), black);
    });
    if (!pixels) return;
    CHECK(ink_box(*pixels) == ui::Box{{50.0, 20.0}, {150.0, 80.0}});
}

TEST_CASE("More vertices than sixteen bits can count are drawn all the same")
{
    const auto pixels = pixels_of([](ui::Painter& p) {
        std::vector<ui::Point> zigzag;
        for (int i = 0; i < 120'000; ++i)
            zigzag.push_back({10.0 + (i % 2 == 0 ? 0.0 : 180.0), 10.0 + 80.0 * i / 120'000.0});
        p.polyline(zigzag, {.color = black});
        p.line({100.0, 95.0}, {120.0, 95.0}, {.color = black, .width = 3.0});
    });
    if (!pixels) return;
    CHECK(pixels->at(100, 12)[0] == 0);
    CHECK(pixels->at(100, 88)[0] == 0);
    CHECK(pixels->at(110, 95)[0] == 0);
}

TEST_CASE("The same drawing gives the same pixels every time")
{
    const auto draw = [](ui::Painter& p) { p.text({100.0, 50.0}, "M = 12.5 kN·m", {.color = black}); };
    const auto first = pixels_of(draw), second = pixels_of(draw);
    CHECK(first == second);
}

TEST_CASE("EGL without a surface draws what OSMesa draws")
{
    const auto drawn_by = [](ui::OffscreenKind kind) -> std::optional<ui::Pixels> {
        try {
            ui::Offscreen context({.size = {40, 30}}, kind);
            ui::DrawListRenderer renderer(context);
            fill(renderer, ui::rgb(0x336699));
            return context.pixels();
        } catch (const ui::ContextError& error) {
            MESSAGE("not compared: ", std::string(error.what()));
            return std::nullopt;
        }
    };
    const auto osmesa = drawn_by(ui::OffscreenKind::OsMesa), egl = drawn_by(ui::OffscreenKind::Egl);
    for (const auto& pixels : {osmesa, egl}) {
        if (!pixels) continue;
        CHECK(pixels->at(20, 15)[0] == 0x33);
        CHECK(pixels->at(20, 15)[1] == 0x66);
        CHECK(pixels->at(20, 15)[2] == 0x99);
    }
    if (osmesa && egl) CHECK(golden::compare(*osmesa, *egl).is_same());
}

TEST_CASE("Two off-screen contexts live side by side")
{
    if (!pixels_of([](ui::Painter&) {})) return;
    ui::Offscreen red({.size = {8, 8}}), blue({.size = {16, 4}});
    ui::DrawListRenderer red_renderer(red);
    fill(red_renderer, ui::rgb(0xFF0000));
    ui::DrawListRenderer blue_renderer(blue);
    fill(blue_renderer, ui::rgb(0x0000FF));
    CHECK(red.pixels().at(4, 4)[0] == 255);
    CHECK(blue.pixels().at(4, 2)[2] == 255);
    CHECK(blue.pixels().size == ui::PixelSize{16, 4});
}

TEST_CASE("A picture without pixels is refused with the sizes that are possible")
{
    if (!pixels_of([](ui::Painter&) {})) return;
    try {
        const ui::Offscreen context({.size = {0, 100}});
        FAIL("no error");
    } catch (const ui::ContextError& error) {
        CHECK(std::string(error.what()).find("picture of 0 x 100 pixels") != std::string::npos);
    }
}

TEST_CASE("A picture that cannot be written is told with the file and the reason, in the reader's language")
{
    const ui::Fonts fonts;
    const ui::Painter painter({100.0, 100.0}, fonts);
    const auto reason = ui::write_picture("tests/no-such-folder/a.svg", painter.picture(), fonts,
                                          {.background = ui::rgb(0xFFFFFF)});
    REQUIRE(reason);
    CHECK(ui::Catalogue()(*reason) == "a.svg was not written: No such file or directory");
    CHECK(ui::Catalogue(ui::Language::Portuguese)(*reason) == "a.svg não foi gravado: o arquivo ou a pasta não existe");
}

TEST_CASE("A PNG that cannot be written is an error that names the file")
{
    if (!pixels_of([](ui::Painter&) {})) return;
    CHECK_THROWS_WITH_AS(ui::paint_to_png("tests/no-such-folder/a.png", {.size = {10.0, 10.0}}, [](ui::Painter&) {}),
                         doctest::Contains("tests/no-such-folder/a.png"), std::runtime_error);
}

TEST_CASE("Without a display a window is refused, and the message says what to use instead")
{
    if (ui::Window::has_display()) return;
    CHECK_THROWS_WITH_AS(ui::Window({.title = "none"}), doctest::Contains("--screenshot"), ui::ContextError);
}

TEST_CASE("Where nothing is to be drawn an off-screen window needs no renderer, and its picture is black")
{
    ui::Offscreen context({.size = {7, 3}}, ui::OffscreenKind::Empty);
    CHECK(context.kind() == ui::OffscreenKind::Empty);
    const ui::Pixels pixels = context.pixels();
    CHECK(pixels.rgba.size() == 4 * 7 * 3);
    CHECK(pixels.at(6, 2)[1] == 0);
    CHECK(pixels.at(6, 2)[3] == 255);
}

TEST_CASE("A window and an off-screen picture take turns in one program")
{
    if (!ui::Window::has_display() || !pixels_of([](ui::Painter&) {})) return;
    const auto corner_of = [](ui::Context& context) {
        std::array<unsigned char, 4> rgba{};
        context.make_current();
        context.gl().ReadPixels(5, 5, 1, 1, ui::gl::rgba, ui::gl::unsigned_byte, rgba.data());
        return ui::Color{rgba[0], rgba[1], rgba[2]};
    };
    ui::Window window({.title = "test", .size = {200.0, 100.0}});
    ui::DrawListRenderer on_screen(window);
    fill(on_screen, ui::rgb(0xFF0000));
    {
        ui::Offscreen picture({.size = {50, 50}});
        ui::DrawListRenderer off_screen(picture);
        fill(off_screen, ui::rgb(0x00FF00));
        CHECK(corner_of(window) == ui::rgb(0xFF0000));
        fill(on_screen, ui::rgb(0x0000FF));
        CHECK(corner_of(picture) == ui::rgb(0x00FF00));
    }
    CHECK(corner_of(window) == ui::rgb(0x0000FF));
}

TEST_SUITE_END();
