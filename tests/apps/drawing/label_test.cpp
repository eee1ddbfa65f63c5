// Labels of a crowded picture: none covers another, a member or a diagram's line.
#include <doctest/doctest.h>

#include "apps/drawing/draw.h"
#include "femoop/analysis/linear_static.h"
#include "tests/apps/drawing/view_model.h"
#include "ui/paint/label_placement.h"
#include "ui/paint/theme.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

using namespace drawing;

TEST_SUITE_BEGIN("frame");

namespace {

view_test::Marks crowded_picture(const ui::Fonts& fonts, ShowSet show)
{
    const femoop::Model model = view_test::model("crowded_frame");
    const femoop::Results results = femoop::analyse(model);
    ui::Painter painter({1600.0, 1000.0}, fonts);
    draw(painter, {model, &results}, {.show = show});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    return marks;
}

auto text_of(const view_test::Marks& marks, std::string_view begin)
{
    return std::ranges::find_if(marks.texts, [&](const auto& text) { return text.words.starts_with(begin); });
}

bool crosses(const ui::Box& box, ui::Point a, ui::Point b)
{
    double from = 0.0;
    double to = 1.0;
    const auto cut = [&](double start, double delta, double low, double high) {
        if (delta == 0.0) return start > low && start < high;
        const double t1 = (low - start) / delta;
        const double t2 = (high - start) / delta;
        from = std::max(from, std::min(t1, t2));
        to = std::min(to, std::max(t1, t2));
        return from < to;
    };
    return cut(a.x, b.x - a.x, box.min.x, box.max.x) && cut(a.y, b.y - a.y, box.min.y, box.max.y);
}

} // namespace

TEST_CASE("The count of labels without room covers no label")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::model("crowded_frame");
    const femoop::Results results = femoop::analyse(model);
    for (double width = 316.0; width < 640.0; width += 16.0) {
        CAPTURE(width);
        ui::Painter painter({width, 742.0}, fonts);
        draw(painter, {model, &results},
             {.show = parse_show("loads,reactions,N,V,M,labels"),
              .theme = ui::ThemeName::Projector,
              .layout = Layout::Overlay});
        view_test::Marks marks(fonts);
        painter.picture().draw_on(marks);
        const auto count = text_of(marks, "labels without room");
        REQUIRE(count != marks.texts.end());
        CHECK(std::ranges::count_if(marks.texts, [&](const auto& text) { return text.box.overlaps(count->box); }) == 1);
    }
}

TEST_CASE("Why there are no results stands below the structure, and leaves it most of a low sheet")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::model("crowded_frame");
    for (const double height : {190.0, 330.0, 742.0}) {
        CAPTURE(height);
        ui::Painter painter({576.0, height}, fonts);
        draw(painter, {.model = model, .reasons = std::vector<std::string>(9, "reason")},
             {.show = parse_show("labels"), .theme = ui::ThemeName::Projector, .layout = Layout::Overlay});
        view_test::Marks marks(fonts);
        painter.picture().draw_on(marks);
        const auto is_reason = [](const auto& text) { return text.words.starts_with("reason"); };
        const auto first = std::ranges::find_if(marks.texts, is_reason);
        REQUIRE(first != marks.texts.end());
        CHECK(first->box.min.y > 0.5 * height);
        for (const auto& text : marks.texts) {
            CAPTURE(text.words);
            const bool is_beside = text.box.min.x > first->box.max.x; // the count of labels that found no room
            CHECK((is_reason(text) || is_beside || text.box.max.y <= first->box.min.y));
        }
    }
}

TEST_CASE("The warmth of a fibre is written on its own side of the member, however crowded it is there")
{
    const ui::Fonts fonts;
    for (const double q : {10.0, -10.0}) {
        femoop::Model model = view_test::simple_beam(5.0, q);
        model.load_cases[0].members.push_back({femoop::MemberId(0U), femoop::TemperatureLoad{30.0, 10.0}});
        for (const double height : {200.0, 300.0, 700.0}) {
            CAPTURE(q);
            CAPTURE(height);
            ui::Painter painter({450.0, height}, fonts);
            draw(painter, {.model = model}, {.show = parse_show("loads,values"), .layout = Layout::Overlay});
            view_test::Marks marks(fonts);
            painter.picture().draw_on(marks);
            const auto top = text_of(marks, "ΔT = +30"), bottom = text_of(marks, "ΔT = +10");
            REQUIRE(top != marks.texts.end());
            REQUIRE(bottom != marks.texts.end());
            CHECK(top->box.max.y < bottom->box.min.y);
        }
    }
}

TEST_CASE("In a frame of five storeys and five bays no label covers another")
{
    const ui::Fonts fonts;
    const view_test::Marks marks = crowded_picture(fonts, parse_show("M,labels"));
    CHECK(marks.texts.size() > 150);
    for (std::size_t i = 0; i < marks.texts.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            CAPTURE(marks.texts[i].words);
            CAPTURE(marks.texts[j].words);
            CHECK(!marks.texts[i].box.overlaps(marks.texts[j].box));
        }
    }
}

TEST_CASE("In a frame of five storeys and five bays no label lies on a member or on a diagram's line")
{
    const ui::Fonts fonts;
    const ui::Theme theme(ui::ThemeName::Light);
    const view_test::Marks marks = crowded_picture(fonts, parse_show("M,labels"));
    int n_lines = 0;
    for (const auto& line : marks.lines) {
        const bool counts = line.stroke == theme.stroke(ui::Role::Member) ||
                            (line.stroke == theme.stroke(ui::Role::BendingMoment) && line.points.size() > 2);
        if (!counts) continue;
        ++n_lines;
        for (const auto& text : marks.texts) {
            CAPTURE(text.words);
            for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
                CHECK(!crosses(text.box, line.points[i], line.points[i + 1]));
        }
    }
    CHECK(n_lines == 2 * 55); // 30 columns and 25 beams, each with its diagram
}

TEST_CASE("In a crowded frame no leader reads as the minus sign of a number")
{
    const ui::Fonts fonts;
    const ui::Theme theme(ui::ThemeName::Light);
    const view_test::Marks marks = crowded_picture(fonts, parse_show("M,labels"));
    int n_leaders = 0;
    for (const auto& line : marks.lines) {
        if (line.stroke != theme.stroke(ui::Role::Leader)) continue;
        ++n_leaders;
        const ui::Point run = line.points[1] - line.points[0];
        if (std::abs(run.y) > 0.4 * std::abs(run.x)) continue; // too steep for a minus sign
        for (const auto& text : marks.texts) {
            CAPTURE(text.words);
            const double middle = 0.5 * (text.box.min.y + text.box.max.y);
            const ui::Box sign{{text.box.min.x - 5.0, middle - 3.0}, {text.box.min.x, middle + 3.0}};
            CHECK(!crosses(sign, line.points[0], line.points[1]));
        }
    }
    CHECK(n_leaders > 20);
}

TEST_CASE("Where all results lie over one another no line runs through a diagram's sign and no label covers it")
{
    const ui::Fonts fonts;
    const ui::Theme theme(ui::ThemeName::Light);
    const femoop::Model model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    ui::Painter painter({700.0, 760.0}, fonts);
    draw(painter, {model, &results},
         {.show = parse_show("loads,reactions,labels,N,V,M,deformed"), .layout = Layout::Overlay});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    int n_signs = 0;
    for (const auto& disc : marks.discs) {
        if (disc.fill != theme.background() || disc.radius != 6.0) continue;
        ++n_signs;
        const ui::Box sign = ui::Box{disc.center, disc.center}.grown(5.5);
        for (const auto& text : marks.texts) {
            CAPTURE(text.words);
            CHECK(!text.box.overlaps(sign));
        }
        for (const auto& line : marks.lines) {
            const bool is_its_own = sign.contains(line.points.front());
            const bool is_below = line.stroke == theme.stroke(ui::Role::Leader) || line.stroke.width < 0.75; // hatching
            if (is_its_own || is_below) continue;
            for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
                CHECK(!crosses(sign, line.points[i], line.points[i + 1]));
        }
    }
    CHECK(n_signs >= 5);
}

TEST_CASE(
    "On the projector every bar of a Pratt truss has its force written, along the bar where there is no other room")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::example("pratt_truss");
    const femoop::Results results = femoop::analyse(model);
    ui::Painter painter({1920.0, 1080.0}, fonts);
    draw(painter, {model, &results},
         {.show = parse_show("loads,reactions,labels,N,deformed"), .theme = ui::ThemeName::Projector});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    const auto n_forces = std::count_if(marks.texts.begin(), marks.texts.end(), [](const auto& text) {
        return text.words == "0" || text.words.ends_with(" (T)") || text.words.ends_with(" (C)");
    });
    CHECK(n_forces == static_cast<std::ptrdiff_t>(model.members.size()));
}

TEST_CASE("On the projector the names of a grillage's members stand beside them without leaders")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::example("grillage");
    ui::Painter painter({1280.0, 800.0}, fonts);
    draw(painter, {model}, {.show = parse_show("members"), .theme = ui::ThemeName::Projector});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    const ui::Theme theme(ui::ThemeName::Projector);
    CHECK(marks.texts.size() == model.members.size());
    for (const auto& line : marks.lines) CHECK(line.stroke != theme.stroke(ui::Role::Leader));
}

TEST_CASE("Lengths of many short steps stand beside their own line")
{
    const ui::Fonts fonts;
    femoop::Model model = view_test::simple_beam(5.0, 3.0);
    model.load_cases[0].members.clear();
    model.nodes[1].at = {0.0, 0.3125, 0.0};
    for (std::size_t i = 2; i <= 16; ++i)
        model.add(femoop::Node{.id = "n" + std::to_string(i), .at = {0.0, 0.3125 * static_cast<double>(i), 0.0}});
    ui::Painter painter({640.0, 720.0}, fonts);
    draw(painter, {model}, {.show = parse_show("values,dimensions"), .theme = ui::ThemeName::Projector});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    const auto n_steps = std::count_if(marks.texts.begin(), marks.texts.end(),
                                       [](const auto& text) { return text.words == "0.3125 m"; });
    CHECK(n_steps == 16);
    for (const auto& line : marks.lines)
        CHECK(line.stroke != ui::Theme(ui::ThemeName::Projector).stroke(ui::Role::Leader));
}

TEST_CASE("Two hundred members with a diagram and its values are drawn in a frame of the screen")
{
    const ui::Fonts fonts;
    femoop::Model model = view_test::simple_beam(400.0, 3.0);
    model.members.clear();
    model.load_cases[0].members.clear();
    for (std::size_t i = 1; i <= 200; ++i) {
        const double x = 2.0 * static_cast<double>(i);
        const auto node = model.add(femoop::Node{.id = "n" + std::to_string(i), .at = {x, 0.1 * x, 0.0}});
        const femoop::NodeId before = i == 1 ? femoop::NodeId{0} : femoop::NodeId{node.index - 1};
        model.add(femoop::Member{.id = "m" + std::to_string(i),
                                 .nodes = {before, node},
                                 .material = femoop::MaterialId{},
                                 .section = femoop::SectionId{}});
        model.load_cases[0].nodes.push_back({.node = node, .components = {{femoop::Dof::uy, -1.0}}});
    }
    model.nodes[0].support->kind = femoop::SupportKind::Fixed;
    const femoop::Results results = femoop::analyse(model);
    const DrawOptions options{.show = {Show::M, Show::Values}};
    const DrawState state{.camera = fitted_camera({model, &results}, options, {1280.0, 800.0}, fonts)};
    const auto begin = std::chrono::steady_clock::now();
    ui::Painter painter({1280.0, 800.0}, fonts);
    draw(painter, {model, &results}, options, state);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    CHECK(painter.picture().n_shapes() > 400);
    CHECK(taken.count() < 0.5); // milliseconds when nothing else runs; the bound is for sanitizers and busy machines
}

TEST_CASE("What is said of a place outside the sheet leaves nothing in it, and is not counted as without room")
{
    const ui::Fonts fonts;
    femoop::Model model = view_test::simple_beam(8.0, 6.5); // 400 px long, from 70 px left of the sheet
    model.nodes.front().id = "LEFT";
    model.load_cases.front().nodes.push_back({femoop::NodeId(0), {{femoop::Dof::uy, femoop::Quantity(-7.25)}}});
    const femoop::Results results = femoop::analyse(model);
    ui::Painter painter({600.0, 400.0}, fonts);
    draw(painter, {model, &results}, {.show = {Show::Loads, Show::NodeNames, Show::Reactions, Show::Values}},
         {.camera = ui::PlaneCamera({-70.0, 200.0}, 50.0)});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    CHECK_FALSE(marks.has_text("LEFT"));
    CHECK_FALSE(marks.has_text("7.25 kN"));
    CHECK(marks.has_text("6.5 kN/m"));
    for (const auto& text : marks.texts) CHECK(text.words.find("without room") == std::string::npos);
}

TEST_CASE("On the projector no name of the portal is smaller than its values or without room")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    const ui::Theme theme(ui::ThemeName::Projector);
    ui::Painter painter({1280.0, 690.0}, fonts);
    draw(
        painter, {model, &results},
        {.show = parse_show("loads,reactions,M,labels"), .theme = ui::ThemeName::Projector, .layout = Layout::Overlay});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    const ui::Size value = ui::label_size(fonts, "42.68", theme.text(ui::Role::BendingMoment));
    for (const char* const name : {"A", "B", "C", "D", "AB", "BC", "CD"}) {
        CAPTURE(name);
        const auto found = std::ranges::find(marks.texts, name, &view_test::Marks::Text::words);
        REQUIRE(found != marks.texts.end());
        CHECK(found->box.height() >= value.height - 1e-9);
    }
}

TEST_CASE("A line load that goes straight on with one value is written where there is room, and missed nowhere else")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::example("gerber_beam");
    const femoop::Results results = femoop::analyse(model);
    ui::Painter painter({576.0, 742.0}, fonts); // of a window of 1280 x 800 between both its panels
    draw(
        painter, {model, &results},
        {.show = parse_show("loads,reactions,M,labels"), .theme = ui::ThemeName::Projector, .layout = Layout::Overlay});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    CHECK(marks.has_text("10 kN/m"));
    for (const char* const name : {"A", "B", "C", "D", "E", "F"}) CHECK(marks.has_text(name));
    for (const auto& text : marks.texts) CHECK(text.words.find("without room") == std::string::npos);
}

TEST_CASE("A load in line with its support's reaction stands on the other side of the node")
{
    const ui::Fonts fonts;
    const ui::Theme theme(ui::ThemeName::Light);
    femoop::Model model = view_test::example("portal"); // A is the foot of a column
    model.load_cases.front().nodes = {{femoop::NodeId(0), {{femoop::Dof::uy, femoop::Quantity(-37.5)}}}};
    const femoop::Results results = femoop::analyse(model);
    ui::Painter painter({900.0, 700.0}, fonts);
    draw(painter, {model, &results}, {.show = {Show::Loads, Show::Reactions, Show::Values}, .layout = Layout::Overlay});
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    const auto found = std::ranges::find(marks.texts, "37.5 kN", &view_test::Marks::Text::words);
    REQUIRE(found != marks.texts.end());
    const ui::Color reaction = theme.stroke(ui::Role::Reaction).color;
    for (const auto& line : marks.lines)
        if (line.stroke.color == reaction) CHECK(line.points.front().y > found->box.max.y);
}

TEST_SUITE_END();
