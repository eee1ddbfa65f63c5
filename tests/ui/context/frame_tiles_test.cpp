#include "ui/context/frame_tiles.h"

#include "tests/golden/scene.h"
#include "ui/context/draw_list_renderer.h"
#include "ui/context/draw_list_surface.h"
#include "ui/context/offscreen.h"
#include "ui/paint/painter.h"

#include <doctest/doctest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr ui::PixelSize frame_size{200, 100};
constexpr ui::Color paper = ui::rgb(0xFFFFFF), ink = ui::rgb(0x000000);

/// A drawing as Dear ImGui would hand it over.
class Frame {
public:
    Frame(const ui::Fonts& fonts, ui::GlyphAtlas& atlas, const ui::Drawing& drawing, const ui::Box& clip)
        : list_(&shared_)
    {
        shared_.InitialFlags = ImDrawListFlags_AllowVtxOffset;
        shared_.ClipRectFullscreen = {0.0F, 0.0F, frame_size.width, frame_size.height};
        list_._ResetForNewFrame();
        const auto corner = [](ui::Point p) { return ImVec2(static_cast<float>(p.x), static_cast<float>(p.y)); };
        list_.PushClipRect(corner(clip.min), corner(clip.max));
        const ui::Picture picture = ui::painted({.size = {frame_size.width, frame_size.height}}, fonts, drawing);
        ui::DrawListSurface surface(list_, atlas, {});
        picture.draw_on(surface);
        data_.DisplaySize = {frame_size.width, frame_size.height};
        data_.CmdLists = &lists_;
        data_.CmdListsCount = 1;
    }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
    const ImDrawData& data() const { return data_; }

private:
    ImDrawListSharedData shared_;
    ImDrawList list_;
    ImDrawList* lists_ = &list_;
    ImDrawData data_;
};

/// Compares drawings that follow one another.
class Comparison {
public:
    std::vector<ui::PixelBox> boxes_after(const ui::Drawing& drawing, ui::Color background = paper,
                                          const ui::Box& clip = {{0.0, 0.0}, {200.0, 100.0}})
    {
        const Frame frame(fonts_, atlas_, drawing, clip);
        tiles_.compare(ui::batches_of(frame.data()), frame_size, background);
        return {tiles_.boxes().begin(), tiles_.boxes().end()};
    }

private:
    ui::Fonts fonts_;
    ui::GlyphAtlas atlas_{fonts_};
    ui::FrameTiles tiles_;
};

ui::Drawing disc_at(ui::Point center)
{
    return [=](ui::Painter& p) { p.disc(center, 4.0, ink); };
}

const std::vector<ui::PixelBox> everything{{0, 0, 200, 100}};

} // namespace

TEST_SUITE_BEGIN("frame tiles");

TEST_CASE("The first frame differs everywhere, the same once more nowhere, another background everywhere")
{
    Comparison comparison;
    CHECK(comparison.boxes_after(disc_at({20.0, 20.0})) == everything);
    CHECK(comparison.boxes_after(disc_at({20.0, 20.0})).empty());
    CHECK(comparison.boxes_after(disc_at({20.0, 20.0}), ink) == everything);
}

TEST_CASE("What moves changes the tiles that it leaves and those that it enters")
{
    Comparison comparison;
    comparison.boxes_after(disc_at({16.0, 16.0}));
    CHECK(comparison.boxes_after(disc_at({112.0, 80.0})) ==
          std::vector<ui::PixelBox>{{0, 0, 32, 32}, {96, 64, 128, 96}});
    CHECK(comparison.boxes_after(disc_at({112.001, 80.0})) == std::vector<ui::PixelBox>{{96, 64, 128, 96}});
}

TEST_CASE("Changed tiles that touch are one box, which goes on through rows alike and ends at the picture's border")
{
    Comparison comparison;
    comparison.boxes_after([](ui::Painter&) {});
    const auto area = [](ui::Painter& p) {
        const std::vector<ui::Point> corners{{40.0, 40.0}, {190.0, 40.0}, {190.0, 90.0}, {40.0, 90.0}};
        p.polygon(corners, ink);
    };
    CHECK(comparison.boxes_after(area) == std::vector<ui::PixelBox>{{32, 32, 192, 96}});
    CHECK(comparison.boxes_after(disc_at({198.0, 98.0})) ==
          std::vector<ui::PixelBox>{{32, 32, 192, 64}, {32, 64, 200, 96}, {192, 96, 200, 100}});
}

TEST_CASE("The order of what lies over one another and the clip count")
{
    const auto two = [](ui::Color first, ui::Color second) {
        return [=](ui::Painter& p) {
            p.disc({16.0, 16.0}, 6.0, first);
            p.disc({18.0, 16.0}, 6.0, second);
        };
    };
    Comparison comparison;
    comparison.boxes_after(two(ink, ui::rgb(0xFF0000)));
    CHECK(comparison.boxes_after(two(ui::rgb(0xFF0000), ink)) == std::vector<ui::PixelBox>{{0, 0, 32, 32}});
    CHECK(comparison.boxes_after(two(ui::rgb(0xFF0000), ink), paper, {{0.0, 0.0}, {15.0, 100.0}}) ==
          std::vector<ui::PixelBox>{{0, 0, 32, 32}});
}

TEST_CASE("A frame drawn over the one before shows what it shows on an empty picture")
{
    const ui::Fonts fonts;
    const ui::Sheet sheet{.size = {frame_size.width, frame_size.height}};
    if (!golden::drawn(ui::painted(sheet, fonts, [](ui::Painter&) {}), fonts, sheet)) return;
    std::mt19937 random(7);
    const auto any = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
    ui::GlyphAtlas atlas(fonts);
    ui::Offscreen kept_context({.size = frame_size}), fresh_context({.size = frame_size});
    kept_context.make_current();
    ui::DrawListRenderer kept(kept_context);
    struct Thing {
        ui::Point at, to;
        ui::Color color;
        int kind;
    };
    std::vector<Thing> things(12);
    const auto renew = [&](Thing& thing) {
        thing = {{any(-20.0, 220.0), any(-20.0, 120.0)},
                 {any(-20.0, 220.0), any(-20.0, 120.0)},
                 ui::with_opacity(ui::rgb(static_cast<std::uint32_t>(any(0.0, 0xFFFFFF))), any(0.2, 1.0)),
                 static_cast<int>(any(0.0, 3.999))};
    };
    std::for_each(things.begin(), things.end(), renew);
    for (int i = 0; i < 60; ++i) {
        CAPTURE(i);
        for (int n = static_cast<int>(any(0.0, 3.0)); n > 0; --n)
            renew(things[static_cast<std::size_t>(any(0.0, 11.99))]);
        const auto drawing = [&](ui::Painter& p) {
            for (const Thing& thing : things) {
                const std::vector<ui::Point> corners{thing.at, thing.to, {thing.at.x, thing.to.y}};
                if (thing.kind == 0) p.polygon(corners, thing.color);
                if (thing.kind == 1) p.line(thing.at, thing.to, {.color = thing.color, .width = 2.5});
                if (thing.kind == 2) p.disc(thing.at, 0.2 * std::abs(thing.to.x), thing.color);
                if (thing.kind == 3) p.text(thing.at, std::to_string(thing.to.x), {.color = thing.color});
            }
        };
        const ui::Box clip{{0.0, 0.0}, {i % 10 < 5 ? 200.0 : 130.0, 100.0}};
        const Frame frame(fonts, atlas, drawing, clip);
        kept_context.make_current();
        kept.render(frame.data(), paper);
        fresh_context.make_current();
        ui::DrawListRenderer(fresh_context).render(frame.data(), paper);
        REQUIRE(kept_context.pixels() == fresh_context.pixels());
    }
}

TEST_SUITE_END();
