// Everything that the Painter can do, on one sheet for each theme.
#include "tests/golden/scene.h"
#include "ui/paint/theme.h"

#include <doctest/doctest.h>

#include <numbers>

namespace {

using ui::Anchor;
using ui::Layer;
using ui::Painter;
using ui::Point;
using ui::Role;
using ui::Theme;

constexpr double pi = std::numbers::pi;

void draw_roles(Painter& painter, const Theme& theme)
{
    const std::pair<Role, const char*> rows[] = {{Role::Member, "member"},       {Role::Bar, "bar"},
                                                 {Role::Load, "load"},           {Role::Reaction, "reaction"},
                                                 {Role::AxialForce, "N"},        {Role::ShearForce, "V"},
                                                 {Role::BendingMoment, "M"},     {Role::Torsion, "T"},
                                                 {Role::Deformed, "deformed"},   {Role::Undeformed, "undeformed"},
                                                 {Role::Mechanism, "mechanism"}, {Role::Dimension, "dimension"},
                                                 {Role::Selection, "selection"}, {Role::Hover, "hover"},
                                                 {Role::Warning, "warning"},     {Role::Error, "error"}};
    double y = 24.0;
    for (const auto& [role, name] : rows) {
        painter.line({20.0, y}, {110.0, y}, theme.stroke(role));
        painter.rectangle({{120.0, y - 6.0}, {145.0, y + 6.0}}, theme.fill(role));
        painter.text({155.0, y}, name, theme.text(role, Anchor::Left));
        y += 1.8 * theme.type().normal;
    }
}

void draw_joins(Painter& painter, const Theme& theme)
{
    double x = 290.0;
    for (const ui::Join join : {ui::Join::Miter, ui::Join::Round, ui::Join::Bevel}) {
        ui::Stroke stroke = theme.stroke(Role::Member);
        stroke.width = 11.0;
        stroke.join = join;
        stroke.cap = join == ui::Join::Miter ? ui::Cap::Square
                                             : (join == ui::Join::Round ? ui::Cap::Round : ui::Cap::Butt);
        painter.polyline({{x, 80.0}, {x + 35.0, 25.0}, {x + 60.0, 90.0}, {x + 75.0, 30.0}}, stroke);
        x += 120.0;
    }
}

/// A moment that changes sign, filled and outlined, over its member.
void draw_diagram(Painter& painter, const Theme& theme)
{
    const Point a{290.0, 170.0}, b{610.0, 140.0};
    const Point normal = ui::left_normal(ui::direction(b - a));
    std::vector<Point> outline{a};
    for (int i = 0; i <= 60; ++i) {
        const double s = i / 60.0;
        outline.push_back(a + s * (b - a) + (34.0 * std::sin(2.0 * pi * s) + 8.0 * s) * normal);
    }
    outline.push_back(b);
    {
        const ui::LayerScope scope(painter, Layer::Areas);
        painter.polygon(outline, theme.fill(Role::BendingMoment));
        painter.polyline(outline, theme.stroke(Role::BendingMoment));
    }
    painter.line(a, b, theme.stroke(Role::Member));
    for (const Point node : {a, b}) {
        painter.disc(node, 5.0, theme.fill(Role::Hinge));
        painter.circle(node, 5.0, theme.stroke(Role::Hinge));
    }
}

void draw_anchors(Painter& painter, const Theme& theme)
{
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const double apart = 5.4 * theme.type().normal;
            const Point at{310.0 + apart * column, 245.0 + 40.0 * row};
            painter.line(at - Point{6.0, 0.0}, at + Point{6.0, 0.0}, theme.stroke(Role::Dimension));
            painter.line(at - Point{0.0, 6.0}, at + Point{0.0, 6.0}, theme.stroke(Role::Dimension));
            painter.text(at, "kN·m", theme.text(Role::Label, static_cast<Anchor>(3 * row + column)));
        }
    }
}

void draw_turned_text(Painter& painter, const Theme& theme)
{
    for (int i = 0; i < 8; ++i) {
        ui::TextStyle style = theme.text(Role::BendingMoment, Anchor::Left);
        style.rotation = i * pi / 4.0;
        const Point from{625.0 + 14.0 * std::cos(style.rotation), 285.0 - 14.0 * std::sin(style.rotation)};
        painter.text(from, "−12.5", style);
    }
}

void draw_arcs_and_clip(Painter& painter, const Theme& theme)
{
    painter.arc({{340.0, 400.0}, 32.0, 0.0, 1.5 * pi}, theme.stroke(Role::LoadMoment));
    painter.arc({{340.0, 400.0}, 22.0, pi / 2.0, -pi}, theme.stroke(Role::ShearForce));
    painter.polygon({{420.0, 370.0}, {500.0, 370.0}, {500.0, 385.0}, {435.0, 385.0}, {435.0, 430.0}, {420.0, 430.0}},
                    theme.stroke(Role::Reaction).color);
    const ui::ClipScope clip(painter, {{540.0, 365.0}, {640.0, 435.0}});
    for (int i = 0; i < 14; ++i)
        painter.line({500.0 + 14.0 * i, 440.0}, {560.0 + 14.0 * i, 360.0}, theme.stroke(Role::Support));
    ui::TextStyle plated = theme.text(Role::Label);
    plated.plate = theme.background();
    painter.text({590.0, 400.0}, "q = 4.2", plated);
}

void draw_text(Painter& painter, const Theme& theme)
{
    ui::TextStyle style = theme.text(Role::Label, Anchor::TopLeft);
    style.size = theme.type().small;
    painter.text({290.0, 450.0}, "Esforço cortante, ação, flexão: θ φ κ Δ ≤ ≥ · × ° ² ³ ⁴ − → ∞", style);
    style.size = theme.type().large;
    style.weight = ui::Weight::Bold;
    painter.text({290.0, 470.0}, "M = q L² / 8", style);
}

void draw_everything(Painter& painter, const Theme& theme)
{
    {
        const ui::LayerScope scope(painter, Layer::Grid);
        for (double x = 0.0; x <= painter.size().width; x += 50.0)
            painter.line({x, 0.0}, {x, painter.size().height}, theme.stroke(Role::Grid));
    }
    draw_roles(painter, theme);
    draw_joins(painter, theme);
    draw_diagram(painter, theme);
    draw_anchors(painter, theme);
    draw_turned_text(painter, theme);
    draw_arcs_and_clip(painter, theme);
    draw_text(painter, theme);
}

void check_sheet(ui::ThemeName name, double scale, const std::string& file)
{
    const Theme theme(name);
    const ui::Sheet sheet{.size = {700.0, name == ui::ThemeName::Projector ? 620.0 : 500.0},
                          .scale = scale,
                          .background = theme.background()};
    golden::check_scene(file, sheet, [&](Painter& painter) { draw_everything(painter, theme); });
}

} // namespace

TEST_SUITE_BEGIN("pictures");

TEST_CASE("The painter's sheet looks as it did, light") { check_sheet(ui::ThemeName::Light, 1.0, "painter_light"); }
TEST_CASE("The painter's sheet looks as it did, dark") { check_sheet(ui::ThemeName::Dark, 1.0, "painter_dark"); }
TEST_CASE("The painter's sheet looks as it did, print") { check_sheet(ui::ThemeName::Print, 1.0, "painter_print"); }
TEST_CASE("The painter's sheet looks as it did, projector")
{
    check_sheet(ui::ThemeName::Projector, 1.0, "painter_projector");
}
TEST_CASE("The painter's sheet looks as it did, at two pixels to one")
{
    check_sheet(ui::ThemeName::Light, 2.0, "painter_hidpi");
}

TEST_SUITE_END();
