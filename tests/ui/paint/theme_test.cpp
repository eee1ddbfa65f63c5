#include "ui/paint/theme.h"

#include <doctest/doctest.h>

#include <cmath>

using doctest::Approx;

namespace {

constexpr ui::ThemeName all_themes[] = {ui::ThemeName::Light, ui::ThemeName::Dark, ui::ThemeName::Print,
                                        ui::ThemeName::Projector};

/// What people see who lack the red, the green or the blue cones, after the matrices of Machado, Oliveira and
/// Fernandes (2009) for complete lack, applied to linear red, green and blue.
enum class Lack { Red, Green, Blue };

struct Linear {
    double r, g, b;
};

Linear linear(ui::Color c)
{
    const auto part = [](std::uint8_t v) { return std::pow(v / 255.0, 2.2); };
    return {part(c.r), part(c.g), part(c.b)};
}

Linear seen(ui::Color color, Lack lack)
{
    static constexpr double m[3][9] = {
        {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998},
        {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881},
        {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900}};
    const auto [r, g, b] = linear(color);
    const double* k = m[static_cast<int>(lack)];
    return {k[0] * r + k[1] * g + k[2] * b, k[3] * r + k[4] * g + k[5] * b, k[6] * r + k[7] * g + k[8] * b};
}

double distance(Linear a, Linear b) { return std::hypot(a.r - b.r, a.g - b.g, a.b - b.b); }

} // namespace

TEST_SUITE_BEGIN("theme");

TEST_CASE("Black on white has the contrast 21 and a colour on itself 1")
{
    CHECK(ui::contrast_ratio(ui::rgb(0x000000), ui::rgb(0xFFFFFF)) == Approx(21.0));
    CHECK(ui::contrast_ratio(ui::rgb(0xD55E00), ui::rgb(0xD55E00)) == Approx(1.0));
}

TEST_CASE("In every theme words of every role reach the contrast 4.5 that WCAG asks for, but for what stands back")
{
    for (const auto name : all_themes) {
        const ui::Theme theme(name);
        for (std::size_t i = 0; i < ui::n_roles; ++i) {
            const auto role = static_cast<ui::Role>(i);
            if (role == ui::Role::Undeformed) continue;
            CAPTURE(ui::text(name));
            CAPTURE(i);
            CHECK(ui::contrast_ratio(theme[role].text, theme.background()) >= 4.5);
        }
    }
}

TEST_CASE("N, V, M and T differ in their dashes, so that a black and white copy still reads")
{
    const ui::Role results[] = {ui::Role::AxialForce, ui::Role::ShearForce, ui::Role::BendingMoment, ui::Role::Torsion};
    for (const auto name : all_themes) {
        const ui::Theme theme(name);
        for (const auto a : results)
            for (const auto b : results)
                if (a != b) CHECK_FALSE(theme.stroke(a).dash == theme.stroke(b).dash);
    }
}

TEST_CASE("The members' own axes have not the hue of the loads nor of the reactions")
{
    for (const auto name : {ui::ThemeName::Light, ui::ThemeName::Dark, ui::ThemeName::Projector}) {
        const ui::Theme theme(name);
        CAPTURE(ui::text(name));
        for (const auto role : {ui::Role::Load, ui::Role::Reaction}) {
            const auto axes = theme.stroke(ui::Role::LocalAxes).color, other = theme.stroke(role).color;
            CHECK(distance(linear(axes), linear(other)) > 0.15);
        }
    }
}

TEST_CASE("People without red, green or blue cones tell loads, moments, shear and the deformed shape apart")
{
    const ui::Role roles[] = {ui::Role::Load, ui::Role::BendingMoment, ui::Role::Reaction, ui::Role::Deformed};
    const ui::Theme theme(ui::ThemeName::Light);
    for (const auto lack : {Lack::Red, Lack::Green, Lack::Blue}) {
        for (const auto a : roles) {
            for (const auto b : roles) {
                if (a == b) continue;
                CAPTURE(static_cast<int>(lack));
                CAPTURE(static_cast<int>(a));
                CAPTURE(static_cast<int>(b));
                const double hue = distance(seen(theme.stroke(a).color, lack), seen(theme.stroke(b).color, lack));
                CHECK(hue > 0.05);
            }
        }
    }
}

TEST_CASE("Things of one kind differ in colour, and in print in their shade and dashes")
{
    for (const auto name : all_themes) {
        const ui::Theme theme(name);
        CAPTURE(ui::text(name));
        for (std::size_t i = 0; i < ui::n_series; ++i) {
            CHECK(ui::contrast_ratio(theme.series(i).text, theme.background()) >= 4.5);
            for (std::size_t j = 0; j < i; ++j) {
                CHECK_FALSE(theme.series(i).fill == theme.series(j).fill);
                CHECK_FALSE(theme.series(i).stroke == theme.series(j).stroke);
            }
        }
    }
}

TEST_CASE("The print theme uses no colour at all")
{
    const ui::Theme theme(ui::ThemeName::Print);
    for (std::size_t i = 0; i < ui::n_roles; ++i) {
        const ui::Color c = theme[static_cast<ui::Role>(i)].stroke.color;
        CHECK(c.r == c.g);
        CHECK(c.g == c.b);
    }
    for (std::size_t i = 0; i < ui::n_series; ++i) CHECK(theme.series(i).fill.r == theme.series(i).fill.b);
}

TEST_CASE("On the projector type is half as large again, and members nearly twice as thick")
{
    const ui::Theme light(ui::ThemeName::Light), projector(ui::ThemeName::Projector);
    CHECK(projector.type().normal >= 1.5 * light.type().normal);
    CHECK(projector.stroke(ui::Role::Member).width >= 1.75 * light.stroke(ui::Role::Member).width);
}

TEST_CASE("Themes are found by their names")
{
    for (const auto name : all_themes) CHECK(ui::theme_named(ui::text(name)) == name);
    CHECK_FALSE(ui::theme_named("sepia"));
}

TEST_CASE("A colour is written as six digits, and as eight where it is not opaque")
{
    CHECK(ui::hex_text(ui::rgb(0x0072B2)) == "#0072b2");
    CHECK(ui::hex_text(ui::with_opacity(ui::rgb(0x0072B2), 0.5)) == "#0072b280");
}

TEST_SUITE_END();
