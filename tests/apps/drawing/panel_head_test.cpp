// Headings of panels: whole or not at all.
#include <doctest/doctest.h>

#include "apps/drawing/sheet/panel_head.h"
#include "tests/apps/drawing/view_model.h"

#include <algorithm>

using namespace drawing;

TEST_SUITE_BEGIN("frame");

namespace {

const PanelHead shear{.name = "Shear force V [kN]",
                      .note = "positive where it turns the piece clockwise",
                      .role = ui::Role::ShearForce,
                      .bar = 57.0,
                      .bar_text = "20 kN"};
const PanelHead moment{.name = "Momento fletor My [kN·m]",
                       .note = "desenhado do lado da fibra tracionada",
                       .role = ui::Role::BendingMoment,
                       .bar = 55.0,
                       .bar_text = "200 kN·m"};

view_test::Marks written(const PanelHead& head, const ui::Theme& theme, double width, const ui::Fonts& fonts)
{
    ui::Painter painter({width, 400.0}, fonts);
    draw_panel_head(painter, head, theme, ui::box_at({}, {width, head_height(head, theme, fonts, width)}));
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    return marks;
}

std::string all_text(const view_test::Marks& marks)
{
    std::string all;
    for (const auto& text : marks.texts) all += (all.empty() ? "" : " ") + text.words;
    return all;
}

} // namespace

TEST_CASE("A panel's heading stays inside its strip and no part covers another, at any width")
{
    const ui::Fonts fonts;
    for (const ui::ThemeName name : {ui::ThemeName::Light, ui::ThemeName::Projector}) {
        const ui::Theme theme(name);
        for (const PanelHead& head : {shear, moment}) {
            for (double width = 16.0 * theme.type().normal; width < 1000.0; width += 7.0) {
                const view_test::Marks marks = written(head, theme, width, fonts);
                const double height = head_height(head, theme, fonts, width);
                CAPTURE(width);
                for (const auto& text : marks.texts) {
                    CAPTURE(text.words);
                    CHECK(text.box.min.x >= 0.0);
                    CHECK(text.box.max.x <= width);
                    CHECK(0.5 * (text.box.min.y + text.box.max.y) < height);
                    for (const auto& other : marks.texts) CHECK((&other == &text || !other.box.overlaps(text.box)));
                }
            }
        }
    }
}

TEST_CASE("Where a heading's line is full, the scale bar and the note go below it")
{
    const ui::Fonts fonts;
    const ui::Theme light(ui::ThemeName::Light), projector(ui::ThemeName::Projector);
    CHECK(all_text(written(shear, light, 225.0, fonts)) ==
          "Shear force V [kN] 20 kN positive where it turns the piece clockwise");
    CHECK(all_text(written(moment, projector, 1280.0 / 3.0, fonts)) ==
          "Momento fletor My [kN·m] 200 kN·m desenhado do lado da fibra tracionada");
}

TEST_CASE("At every width that holds its words a note is written whole, and a head takes no line that it leaves empty")
{
    const ui::Fonts fonts;
    const ui::Theme theme(ui::ThemeName::Light);
    for (double width = 225.0; width < 700.0; width += 5.0) {
        CAPTURE(width);
        const view_test::Marks marks = written(shear, theme, width, fonts);
        CHECK(all_text(marks) == "Shear force V [kN] 20 kN positive where it turns the piece clockwise");
        double lowest = 0.0;
        for (const auto& text : marks.texts) lowest = std::max(lowest, text.box.max.y);
        CHECK(head_height(shear, theme, fonts, width) < lowest + 8.0);
    }
    CHECK(head_height({.name = "Loads", .note = {}}, theme, fonts, 225.0) == doctest::Approx(1.6 * 13.0));
}

TEST_CASE("A scale bar without room is left out with its text, and a note goes whole")
{
    const ui::Fonts fonts;
    const ui::Theme theme(ui::ThemeName::Light);
    const view_test::Marks marks = written(shear, theme, 100.0, fonts);
    CHECK(marks.lines.empty());
    CHECK(all_text(marks) == "Shear force V [kN]");
}

TEST_SUITE_END();
