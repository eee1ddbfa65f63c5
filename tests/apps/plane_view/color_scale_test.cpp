// Colours of bands.
#include <doctest/doctest.h>

#include "apps/plane/view/color_scale.h"

using namespace plane;

namespace {

double lightness(ui::Color c) { return 0.30 * c.r + 0.59 * c.g + 0.11 * c.b; }

} // namespace

TEST_CASE("Below zero bands are blue, above it vermillion, and those beside zero are pale")
{
    const auto colors = band_colors({-40.0, -20.0, 0.0, 20.0, 40.0, 60.0}, ui::Theme(ui::ThemeName::Light));
    REQUIRE(colors.size() == 5);
    CHECK(colors[0].b > colors[0].r);
    CHECK(colors[4].r > colors[4].b);
    for (const std::size_t pale : {1u, 2u}) CHECK(lightness(colors[pale]) > lightness(colors[0]));
    CHECK(lightness(colors[2]) > lightness(colors[3]));
    CHECK(lightness(colors[3]) > lightness(colors[4]));
}

TEST_CASE("Of a range of one sign, and in print, every band is darker than the one before")
{
    for (const ui::ThemeName theme : {ui::ThemeName::Light, ui::ThemeName::Projector, ui::ThemeName::Print}) {
        const auto colors = band_colors({5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0}, ui::Theme(theme));
        for (std::size_t i = 1; i < colors.size(); ++i) CHECK(lightness(colors[i]) < lightness(colors[i - 1]));
    }
    const auto gray = band_colors({-40.0, 0.0, 40.0, 80.0}, ui::Theme(ui::ThemeName::Print));
    CHECK(gray[0].r == gray[0].b);
    CHECK(lightness(gray[2]) < lightness(gray[0]));
}
