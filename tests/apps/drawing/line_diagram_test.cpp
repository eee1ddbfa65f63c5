// Diagrams of functions that are no section force: influence lines of a beam on two supports, drawn with the same
// marks.
#include "apps/drawing/results/line_diagram.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>

#include "apps/drawing/results/marked_values.h"
#include "tests/apps/drawing/view_model.h"

using namespace drawing;
using femoop::Side;

namespace {

constexpr double span = 8.0, section = 2.0; // L, and a: the section whose moment and shear force are asked for

/// A function of two straight pieces, from 0 at both ends to its values beside the section.
class TwoPieces final : public LineFunction {
public:
    TwoPieces(double before, double after) : before_(before), after_(after) {}

    double length() const override { return span; }
    std::vector<double> breaks() const override { return {0.0, section, span}; }
    double value(double x, Side side = Side::After) const override
    {
        return is_first(x, side) ? before_ * x / section : after_ * (span - x) / (span - section);
    }
    femoop::Extremes extremes() const override
    {
        return {.max = {section, std::max({before_, after_, 0.0})}, .min = {section, std::min({before_, after_, 0.0})}};
    }
    std::optional<double> slope(double x, Side side) const override
    {
        return is_first(x, side) ? before_ / section : -after_ / (span - section);
    }
    std::vector<double> level_places() const override { return {}; }

private:
    static bool is_first(double x, Side side) { return x < section || (x == section && side == Side::Before); }

    double before_, after_;
};

/// Of the bending moment in the section: a load at the section itself gives a (L - a) / L of its size.
const TwoPieces moment_line(section*(span - section) / span, section*(span - section) / span);
/// Of its shear force: it jumps by 1.
const TwoPieces shear_line(-section / span, 1.0 - section / span);

/// \param taken  where no label finds room
view_test::Marks drawn(const LineFunction& function, double largest, const ui::Fonts& fonts,
                       std::optional<ui::Box> taken = {})
{
    const femoop::Model model = view_test::simple_beam(span, 1.0);
    const StructureShape shape = shape_of(model);
    ui::Painter painter({600.0, 400.0}, fonts);
    const Projection projection(ui::PlaneCamera({50.0, 200.0}, 60.0));
    const LevelOfDetail crowding(shape, projection);
    const DrawOptions options{.show = {Show::Values}};
    const ui::DisplayUnits units = display_units(model, options);
    const ui::Theme theme(ui::ThemeName::Light);
    Sketch sketch({.painter = &painter, .theme = &theme, .room = painter.sheet()});
    if (taken) sketch.reserve(*taken);
    const DrawState state;
    const Scene scene{model, shape, projection, options, state, units, sketch, crowding, options.show};
    const MemberShape& member = shape.members.front();
    draw(scene, function,
         {.frame = scene.frame_on(member, 0.0), .largest = largest, .pixels_per_unit = 40.0, .text = [&](double value) {
              return scene.number(value, ui::Measure::Plain);
          }});
    sketch.write_captions();
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    return marks;
}

bool runs_through(const view_test::Marks& marks, ui::Point place)
{
    return std::ranges::any_of(marks.lines, [&](const auto& line) {
        return std::ranges::any_of(line.points, [&](ui::Point p) { return ui::distance(p, place) < 1e-6; });
    });
}

} // namespace

TEST_SUITE("drawing: diagrams of functions")
{

    TEST_CASE("The influence line of a moment is marked at its kink, a (L - a) / L")
    {
        const std::vector<MarkedValue> marks = marked_values(moment_line, 1e-9);
        REQUIRE(marks.size() == 1);
        CHECK(marks[0].x == section);
        CHECK(marks[0].value == doctest::Approx(section * (span - section) / span));
        CHECK(marks[0].is_peak);
    }

    TEST_CASE("The influence line of a shear force is marked on both sides of its jump by 1")
    {
        const std::vector<MarkedValue> marks = marked_values(shear_line, 1e-9);
        REQUIRE(marks.size() == 2);
        CHECK(marks[0].value == doctest::Approx(-section / span));
        CHECK(marks[1].value == doctest::Approx(1.0 - section / span));
    }

    TEST_CASE("Influence lines are drawn at their ordinates and with their values")
    {
        const ui::Fonts fonts;
        const view_test::Marks moment = drawn(moment_line, section * (span - section) / span, fonts);
        CHECK(moment.has_text("1.5"));
        CHECK(runs_through(moment, {50.0 + 60.0 * section, 200.0 - 40.0 * 1.5}));
        const view_test::Marks shear = drawn(shear_line, 1.0 - section / span, fonts);
        CHECK(shear.has_text("−0.25"));
        CHECK(shear.has_text("0.75"));
        CHECK(runs_through(shear, {50.0 + 60.0 * section, 200.0 + 40.0 * 0.25}));
        CHECK(runs_through(shear, {50.0 + 60.0 * section, 200.0 - 40.0 * 0.75}));
    }

    TEST_CASE("A value whose place is taken stays on the side of its ordinate")
    {
        const ui::Fonts fonts;
        const TwoPieces low(0.1, 0.1); // 4 px high: what stands below it would be read as a value there
        const ui::Box around_its_place{{130.0, 150.0}, {210.0, 194.0}};
        const view_test::Marks marks = drawn(low, 0.1, fonts, around_its_place);
        REQUIRE(marks.has_text("0.1"));
        for (const view_test::Marks::Text& text : marks.texts) CHECK(text.box.center().y < 200.0);
    }

    TEST_CASE("Of a function that is rounding beside the largest value nothing is drawn")
    {
        const ui::Fonts fonts;
        CHECK(drawn(shear_line, 1e6, fonts).lines.empty());
    }

} // TEST_SUITE
