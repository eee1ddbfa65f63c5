#include "tests/golden/scene.h"
#include "ui/context/pixels.h"
#include "ui/context/rasterize.h"
#include "ui/paint/painter.h"

#include <doctest/doctest.h>

#include <array>
#include <memory>
#include <optional>

namespace {

using Rgb = std::array<int, 3>;

constexpr Rgb red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, yellow{255, 255, 0}, white{255, 255, 255};

/// Red and green above blue and yellow.
std::shared_ptr<const ui::Photo> four_colors()
{
    ui::Photo photo;
    photo.image = {.width = 2, .height = 2, .pixels = {}, .version = 1, .kind = ui::PixelKind::Color};
    for (const Rgb& color : {red, green, blue, yellow}) {
        for (const int part : color) photo.image.pixels.push_back(static_cast<std::uint8_t>(part));
        photo.image.pixels.push_back(255);
    }
    return std::make_shared<const ui::Photo>(photo);
}

/// On white paper; nothing where there is no renderer, which is said.
std::optional<ui::Pixels> paper_with(const ui::Drawing& drawing)
{
    const ui::Fonts fonts;
    const ui::Sheet sheet{.size = {200.0, 100.0}};
    return golden::drawn(ui::painted(sheet, fonts, drawing), fonts, sheet);
}

Rgb color_at(const ui::Pixels& pixels, int x, int y)
{
    const std::uint8_t* const at = pixels.at(x, y);
    return {at[0], at[1], at[2]};
}

std::optional<ui::Pixels> paper_with_photo(const ui::ImagePlace& place)
{
    return paper_with([&](ui::Painter& p) { p.photo(four_colors(), place); });
}

} // namespace

TEST_SUITE_BEGIN("photo");

TEST_CASE("A photo stands upright where it is put, and nothing is drawn beside it")
{
    const auto pixels = paper_with_photo({.corner = {20.0, 10.0}, .right = {80.0, 0.0}, .down = {0.0, 80.0}});
    if (!pixels) return;
    CHECK(color_at(*pixels, 30, 20) == red);
    CHECK(color_at(*pixels, 90, 20) == green);
    CHECK(color_at(*pixels, 30, 80) == blue);
    CHECK(color_at(*pixels, 90, 80) == yellow);
    CHECK(color_at(*pixels, 18, 20) == white);
    CHECK(color_at(*pixels, 30, 92) == white);
}

TEST_CASE("A photo turned by a quarter to the left has its right side above")
{
    const auto pixels = paper_with_photo({.corner = {20.0, 90.0}, .right = {0.0, -80.0}, .down = {80.0, 0.0}});
    if (!pixels) return;
    CHECK(color_at(*pixels, 30, 80) == red);
    CHECK(color_at(*pixels, 30, 20) == green);
    CHECK(color_at(*pixels, 90, 80) == blue);
    CHECK(color_at(*pixels, 90, 20) == yellow);
}

TEST_CASE("Of a photo a million times as large as the sheet the right part is seen")
{
    const auto pixels = paper_with_photo(
        {.corner = {100.0 - 1e8, 50.0 - 1e8}, .right = {2e8, 0.0}, .down = {0.0, 2e8}});
    if (!pixels) return;
    const Rgb middle = color_at(*pixels, 100, 50); // half way between the four
    for (const int part : middle) CHECK(std::abs(part - 128) <= 64);
    CHECK(color_at(*pixels, 5, 5) == color_at(*pixels, 195, 95));
    const auto corner = paper_with_photo({.corner = {100.0, 50.0}, .right = {2e8, 0.0}, .down = {0.0, 2e8}});
    CHECK(color_at(*corner, 150, 80) == red);
    CHECK(color_at(*corner, 95, 80) == white);
}

TEST_CASE("A pale photo lets the paper through")
{
    const auto pixels = paper_with_photo(
        {.corner = {20.0, 10.0}, .right = {80.0, 0.0}, .down = {0.0, 80.0}, .opacity = 0.4});
    if (!pixels) return;
    const Rgb pale = color_at(*pixels, 30, 20);
    CHECK(pale[0] == 255);
    CHECK(std::abs(pale[1] - 153) <= 1);
    CHECK(std::abs(pale[2] - 153) <= 1);
}

TEST_CASE("Lines, areas and words over a photo keep their colours")
{
    const auto with_lines = [](ui::Painter& p, bool has_photo) {
        const ui::LayerScope layer(p, ui::Layer::Background);
        if (has_photo) p.photo(four_colors(), {.corner = {}, .right = {200.0, 0.0}, .down = {0.0, 100.0}});
        p.rectangle({{0.0, 0.0}, {200.0, 100.0}}, ui::rgb(0xFFFFFF));
        p.line({10.0, 50.0}, {190.0, 50.0}, {.color = ui::rgb(0x204060), .width = 5.0});
        p.text({100.0, 20.0}, "M = 12.5", {.size = 20.0});
        p.disc({30.0, 80.0}, 10.0, ui::rgb(0x604020));
    };
    const auto with = paper_with([&](ui::Painter& p) { with_lines(p, true); });
    const auto without = paper_with([&](ui::Painter& p) { with_lines(p, false); });
    if (!with) return;
    CHECK(*with == *without);
}

TEST_SUITE_END();
