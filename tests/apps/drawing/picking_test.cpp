// What lies under the cursor.
#include <doctest/doctest.h>

#include "apps/drawing/draw.h"
#include "apps/drawing/pick.h"
#include "apps/drawing/reading.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/result/envelope.h"
#include "tests/apps/drawing/view_model.h"
#include "ui/paint/label/oriented_box.h"
#include "ui/paint/theme.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace drawing;

TEST_SUITE_BEGIN("frame");

namespace {

constexpr double picked_span = 8.0, picked_load = 5.0;
const ui::PlaneCamera camera({100.0, 300.0}, 50.0); // the beam runs from (100, 300) to (500, 300)

struct PickingScene {
    femoop::Model model = view_test::simple_beam(picked_span, picked_load);
    femoop::Results results = femoop::analyse(model);
    ui::Fonts fonts;
    ui::Painter painter{{900.0, 600.0}, fonts};
    DrawOptions options{.show = {Show::Loads}};

    Pick at(ui::Point cursor) const { return pick(shape_of(model), Projection(camera), cursor, options.show); }
};

Subject::Plan drawn_plan(ui::Painter& painter, const DrawInput& input, const DrawOptions& options)
{
    const DrawState state;
    return Subject(input, options, state).draw(painter).plan;
}

} // namespace

TEST_CASE("Near a node the node is picked, beside it the member with the place along it")
{
    const PickingScene scene;
    CHECK(scene.at({503.0, 298.0}).node == femoop::NodeId{1});
    const Pick member = scene.at({250.0, 304.0});
    CHECK(!member.node);
    REQUIRE(member.cut);
    CHECK(member.cut->x == doctest::Approx(3.0));
    CHECK(scene.at({250.0, 340.0}).is_nothing());
}

TEST_CASE("Over a diagram a member is picked from farther off")
{
    PickingScene scene;
    scene.options.show = {Show::M};
    const Pick member = scene.at({300.0, 340.0});
    REQUIRE(member.cut);
    CHECK(member.cut->x == doctest::Approx(4.0));
}

TEST_CASE("A hand takes hold of a moment's arrow anywhere along its arc, however large symbols are")
{
    femoop::Model model = view_test::simple_beam(picked_span, picked_load);
    model.load_cases[0].nodes.push_back(
        {.node = femoop::NodeId{1}, .components = {{femoop::Dof::rz, femoop::Quantity(12.0)}}});
    const ui::Fonts fonts;
    for (const ui::ThemeName theme : {ui::ThemeName::Light, ui::ThemeName::Projector}) {
        ui::Painter painter({900.0, 600.0}, fonts);
        const DrawOptions options{.show = {Show::Loads}, .theme = theme};
        const DrawInput input{model, nullptr};
        const DrawState state;
        const std::vector<LoadMark> marks = Subject(input, options, state).draw(painter).grips.loads;
        const auto mark = std::ranges::find(marks, femoop::Dof::rz, &LoadMark::dof);
        REQUIRE(mark != marks.end());
        const double radius = ui::distance(mark->root, mark->tip);
        CHECK(radius == doctest::Approx(18.0 * ui::Theme(theme).symbol_scale()));
        for (int degrees = -135; degrees <= 135; degrees += 15) { // 0: to the right
            CAPTURE(degrees);
            const double angle = degrees * std::numbers::pi / 180.0;
            const ui::Point on_arc = mark->root + radius * ui::Point{std::cos(angle), -std::sin(angle)};
            const auto is_near = [&](ui::Point p) { return ui::distance(p, on_arc) < 9.0; };
            CHECK(std::ranges::any_of(mark->area, is_near));
        }
    }
}

TEST_CASE("A reading tells the section's forces with units")
{
    PickingScene scene;
    const DrawInput input{scene.model, &scene.results};
    const Subject::Plan plan = Subject(input, scene.options, {}).plan(scene.painter.size(), scene.fonts);
    draw_reading(scene.painter, input, scene.options,
                 {.plan = plan, .cut = {femoop::MemberId{}, 2.0}, .beside = {200.0, 310.0}});
    view_test::Marks marks(scene.fonts);
    scene.painter.picture().draw_on(marks);
    CHECK(marks.has_text("2 m"));
    CHECK(marks.has_text("10 kN"));   // V = q (L / 2 - x)
    CHECK(marks.has_text("30 kN·m")); // M = q x (L - x) / 2
    for (const auto& text : marks.texts) CHECK(scene.painter.sheet().contains(text.box));
}

TEST_CASE("A reading shows zero where there is nothing but rounding, and a true minus sign")
{
    const femoop::Model model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    std::map<std::string, std::string> read; // in the middle of the beam, on the axis of symmetry
    for (const ReadingLine& line : reading(model, results, {}, {femoop::MemberId{1}, 4.0}))
        read[line.name] = line.value;
    CHECK(read["x"] == "4 m");
    CHECK(read["N"] == "−14.2 kN");
    CHECK(read["V"] == "0 kN");
    CHECK(read["u"] == "0 mm");
}

TEST_CASE("A reading in an envelope tells the least and the largest, with the cases that govern")
{
    const femoop::Model model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    DrawOptions options{.is_envelope = true};
    double least = 1e9, most = -1e9;
    for (std::size_t i = 0; i < results.n_cases(); ++i) {
        const double M = results[femoop::CaseId(i)].curve(femoop::MemberId{1}).value(femoop::MemberComponent::Mz, 2.0);
        least = std::min(least, M);
        most = std::max(most, M);
    }
    const femoop::GoverningRange range = femoop::Envelope(results).at(femoop::MemberId{1}, femoop::MemberComponent::Mz,
                                                                      2.0);
    CHECK(range.min.value == least);
    CHECK(range.max.value == most);
    std::string read;
    for (const ReadingLine& line : reading(model, results, options, {femoop::MemberId{1}, 2.0}))
        if (line.name == "M") read = line.value;
    CAPTURE(read);
    CHECK(read.find(" (" + model.case_name(range.min.load_case) + ") … ") != std::string::npos);
    CHECK(read.ends_with("(" + model.case_name(range.max.load_case) + ") kN·m"));
}

TEST_CASE("The card of a reading covers no string anywhere, where the sheet has room for it at all")
{
    const femoop::Model model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    const ui::Fonts fonts;
    const DrawOptions options{.show = shown_by_default | ShowSet{Show::M}, .layout = Layout::Overlay};
    for (const double x : {0.3, 2.0, 4.0, 7.7})
        for (const ui::Point beside : {ui::Point{200.0, 120.0}, {450.0, 250.0}, {600.0, 560.0}, {120.0, 500.0}}) {
            CAPTURE(x);
            ui::Painter painter({900.0, 620.0}, fonts);
            const Subject::Plan plan = drawn_plan(painter, {model, &results}, options);
            const std::vector<ui::Box> before = painter.picture().text_boxes(fonts);
            draw_reading(painter, {model, &results}, options,
                         {.plan = plan, .cut = {femoop::MemberId{1}, x}, .beside = beside});
            const std::vector<ui::Box> after = painter.picture().text_boxes(fonts);
            for (std::size_t i = 0; i < before.size(); ++i)
                for (std::size_t j = before.size(); j < after.size(); ++j) CHECK(!before[i].overlaps(after[j]));
        }
}

TEST_CASE("The card of a reading covers no string of the picture where there is room beside them")
{
    const femoop::Model model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    const ui::Fonts fonts;
    ui::Painter painter({900.0, 620.0}, fonts);
    const DrawOptions options{.show = shown_by_default | ShowSet{Show::M}, .layout = Layout::Overlay};
    const Subject::Plan plan = drawn_plan(painter, {model, &results}, options);
    const std::vector<ui::Box> before = painter.picture().text_boxes(fonts);
    draw_reading(painter, {model, &results}, options,
                 {.plan = plan, .cut = {femoop::MemberId{1}, 4.0}, .beside = {450.0, 250.0}});
    const std::vector<ui::Box> after = painter.picture().text_boxes(fonts);
    for (std::size_t i = 0; i < before.size(); ++i)
        for (std::size_t j = before.size(); j < after.size(); ++j) CHECK(!before[i].overlaps(after[j]));
}

TEST_CASE("The mark of a section and the leader of its card run through no string of the picture")
{
    const femoop::Model model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    const ui::Fonts fonts;
    ui::Painter painter({662.0, 758.0}, fonts);
    const DrawOptions options{.show = shown_by_default | ShowSet{Show::M}, .layout = Layout::Overlay};
    const Subject::Plan plan = drawn_plan(painter, {model, &results}, options);
    const std::vector<ui::Box> strings = painter.picture().text_boxes(fonts);
    draw_reading(painter, {model, &results}, options,
                 {.plan = plan, .cut = {femoop::MemberId{1}, 4.0}, .beside = {336.0, 325.0}}); // above the name BC
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    const ui::Theme theme(options.theme);
    int n_pieces = 0;
    for (const auto& line : marks.lines) {
        const bool is_mark = line.stroke == theme.stroke(ui::Role::Selection);
        if (!is_mark && line.stroke != theme.stroke(ui::Role::Leader)) continue;
        n_pieces += is_mark ? 1 : 0;
        for (const ui::Box& string : strings) {
            const ui::OrientedBox words(string.center(), string.size());
            CHECK(!words.meets_segment(line.points[0], line.points[1]));
        }
    }
    CHECK(n_pieces > 0);
}

TEST_SUITE_END();
