// What the diagrams say, where they lie, and how they are scaled.
#include <doctest/doctest.h>

#include "apps/drawing/draw.h"
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/envelope_cases.h"
#include "apps/drawing/results/locked_scale.h"
#include "apps/drawing/results/marked_values.h"
#include "apps/drawing/results/solved_case.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/result/envelope.h"
#include "tests/apps/drawing/view_model.h"
#include "tests/frame_maker.h"
#include "ui/paint/label/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

using namespace drawing;
using femoop::MemberComponent;

TEST_SUITE_BEGIN("frame");

namespace {

constexpr double L = 7.0, q = 12.0;
constexpr ui::Size sheet{900.0, 500.0};

view_test::Marks marks_of(const femoop::Model& model, const DrawOptions& options, const ui::Fonts& fonts)
{
    const femoop::Results results = femoop::analyse(model);
    ui::Painter painter(sheet, fonts);
    draw(painter, {model, &results}, options);
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    return marks;
}

/// The middle height of the filled diagram and the height of the member that it stands on.
struct Sides {
    double diagram = 0.0;
    double member = 0.0;
};

Sides sides(MomentSide side)
{
    const ui::Fonts fonts;
    DrawOptions options{.show = {Show::M}, .moment_side = side};
    const view_test::Marks marks = marks_of(view_test::simple_beam(L, q), options, fonts);
    const ui::Theme theme(options.theme);
    Sides found;
    for (const auto& area : marks.areas)
        if (area.fill == theme.fill(ui::Role::BendingMoment)) found.diagram = area.points[area.points.size() / 2].y;
    for (const auto& line : marks.lines)
        if (line.stroke == theme.stroke(ui::Role::Member)) found.member = line.points.front().y;
    return found;
}

} // namespace

TEST_CASE("A former value beyond 2.5 times the present one is drawn to a round part of its scale")
{
    constexpr double present = 3.0;
    CHECK(part_of_scale(0.0, present) == 1);
    CHECK(part_of_scale(2.4 * present, present) == 1);
    CHECK(part_of_scale(2.6 * present, present) == 2);
    CHECK(part_of_scale(12.0 * present, present) == 5);
    CHECK(part_of_scale(1e3 * present, present) == 500);
}

TEST_CASE("The sagging moment of a beam is drawn below it, or above it on the compression side")
{
    const Sides tension = sides(MomentSide::Tension);
    CHECK(tension.diagram > tension.member + 20.0); // y is down on the sheet
    const Sides compression = sides(MomentSide::Compression);
    CHECK(compression.diagram < compression.member - 20.0);
}

TEST_CASE("Values at equal steps are those of the parabola q x (L - x) / 2, and the extreme is written once")
{
    const ui::Fonts fonts;
    DrawOptions options{.show = {Show::M, Show::Values, Show::StepValues}, .steps = 4};
    const view_test::Marks marks = marks_of(view_test::simple_beam(L, q), options, fonts);
    const ui::DisplayUnits units = display_units(view_test::simple_beam(L, q), options);
    std::vector<std::string> written;
    for (const auto& text : marks.texts) written.push_back(text.words);
    const auto moment = [&](double x) { return units.number(q * x * (L - x) / 2, ui::Measure::Moment); };
    CHECK(std::ranges::count(written, moment(L / 4)) == 2);
    CHECK(std::ranges::count(written, moment(L / 2)) == 1);
}

TEST_CASE("The moment of a simple beam is marked once: q L^2 / 8 in its middle")
{
    const auto results = femoop::analyse(view_test::simple_beam(L, q));
    const femoop::Curve curve = results[femoop::CaseId{}].curve(femoop::MemberId{});
    const auto marked = marked_values(SectionForce(curve, MemberComponent::Mz), 1e-6);
    REQUIRE(marked.size() == 1);
    CHECK(marked[0].x == doctest::Approx(L / 2));
    CHECK(marked[0].value == doctest::Approx(q * L * L / 8));
    CHECK(marked[0].is_peak);
}

TEST_CASE("The shear force of a simple beam is marked at its two ends: q L / 2 and - q L / 2")
{
    const auto results = femoop::analyse(view_test::simple_beam(L, q));
    const femoop::Curve curve = results[femoop::CaseId{}].curve(femoop::MemberId{});
    const auto marked = marked_values(SectionForce(curve, MemberComponent::Vy), 1e-6);
    REQUIRE(marked.size() == 2);
    CHECK(marked[0].value == doctest::Approx(q * L / 2));
    CHECK(marked[1].value == doctest::Approx(-q * L / 2));
}

TEST_CASE("Under a point load both sides of the jump and the kink of the moment are marked")
{
    femoop::Model model = view_test::simple_beam(L, q);
    constexpr double P = 30.0, a = 2.0;
    femoop::PointLoad load{.at = femoop::Quantity(a)};
    load.components.push_back({.dof = femoop::Dof::uy, .value = -P});
    model.load_cases[0].members.assign(1, {.member = femoop::MemberId{}, .load = load});
    const femoop::Curve curve = femoop::analyse(model)[femoop::CaseId{}].curve(femoop::MemberId{});
    const auto shear = marked_values(SectionForce(curve, MemberComponent::Vy), 1e-6);
    REQUIRE(shear.size() == 2); // one per stretch, in its middle
    CHECK(shear[0].x == doctest::Approx(a / 2));
    CHECK(shear[0].value == doctest::Approx(P * (L - a) / L));
    CHECK(shear[1].value == doctest::Approx(-P * a / L));
    const auto moment = marked_values(SectionForce(curve, MemberComponent::Mz), 1e-6);
    REQUIRE(moment.size() == 1);
    CHECK(moment[0].x == doctest::Approx(a));
    CHECK(moment[0].value == doctest::Approx(P * a * (L - a) / L));
}

TEST_CASE("The values of a picture are those of the beam, with the decimal mark of the language")
{
    const ui::Fonts fonts;
    DrawOptions options{.show = parse_show("loads,reactions,M,V,values")};
    const view_test::Marks marks = marks_of(view_test::simple_beam(L, q), options, fonts);
    for (const char* words : {"12 kN/m", "42 kN", "73.5", "42", "−42"}) {
        CAPTURE(words);
        CHECK(marks.has_text(words));
    }
    options.numbers.mark = ui::DecimalMark::Comma;
    CHECK(marks_of(view_test::simple_beam(L, q), options, fonts).has_text("73,5"));
}

TEST_CASE("A diagram that is rounding beside the other forces counts as zero")
{
    const femoop::Model arch = view_test::example("three_hinged_arch"); // on its funicular: M = 0
    const auto results = femoop::analyse(arch);
    const auto solved = solved_case(results, femoop::CaseId{});
    REQUIRE(solved);
    CHECK(largest_value(*solved, MemberComponent::Mz, 24.0) == 0.0);
    CHECK(largest_value(*solved, MemberComponent::N, 24.0) > 100.0);
}

TEST_CASE("A diagram that is rounding beside what stands on a support counts as zero")
{
    femoop::Model bridge = view_test::example("influence");
    bridge.load_cases.push_back(
        {.id = "P",
         .members = {{femoop::MemberId(0),
                      femoop::PointLoad{.at = femoop::Quantity(0.0), .components = {{femoop::Dof::uy, -1.0}}}}}});
    const auto results = femoop::analyse(bridge);
    const auto solved = solved_case(results, femoop::CaseId{});
    REQUIRE(solved);
    CHECK(solved->largest(MemberComponent::Mz) > 0.0); // 4e-16
    CHECK(largest_value(*solved, MemberComponent::Mz, 32.5) == 0.0);
}

TEST_CASE("Round scales are 1, 2 or 5 times a power of ten")
{
    CHECK(round_below(73.0) == doctest::Approx(50.0));
    CHECK(round_below(0.0399) == doctest::Approx(0.02));
    CHECK(round_below(1.0) == doctest::Approx(1.0));
    CHECK(round_below(4.9999) == doctest::Approx(2.0));
}

TEST_CASE("A model without nodes, with members of no length or with a faulty case draws without fault")
{
    const ui::Fonts fonts;
    ui::Painter painter(sheet, fonts);
    draw(painter, {femoop::Model{}}, {});
    femoop::Model flat = view_test::simple_beam(L, q);
    flat.nodes[1].at = flat.nodes[0].at;
    draw(painter, {flat}, {});
    draw(painter, {view_test::simple_beam(L, q)}, {.load_case = femoop::CaseId{9}});
    CHECK(painter.picture().n_shapes() > 0);
}

TEST_CASE("A diagram that keeps the scale of another load is as much larger as its load")
{
    const ui::Fonts fonts;
    const femoop::Model lighter = view_test::simple_beam(L, q);
    const auto before = locked_scale(lighter, femoop::analyse(lighter), femoop::CaseId(0));
    const auto depth = [&](double load, const std::optional<LockedScale>& scale) {
        const femoop::Model model = view_test::simple_beam(L, load);
        const femoop::Results results = femoop::analyse(model);
        ui::Painter painter({900.0, 600.0}, fonts);
        draw(painter, {model, &results}, {.show = {Show::M}},
             {.camera = ui::PlaneCamera({100.0, 200.0}, 50.0), .locked_scale = scale});
        view_test::Marks marks(fonts);
        painter.picture().draw_on(marks);
        double lowest = 0.0;
        for (const auto& area : marks.areas)
            for (const ui::Point p : area.points) lowest = std::max(lowest, p.y - 200.0);
        return lowest;
    };
    CHECK(depth(1.6 * q, std::nullopt) == doctest::Approx(depth(q, std::nullopt)));
    CHECK(depth(1.6 * q, before) == doctest::Approx(1.6 * depth(q, std::nullopt)));
    CHECK(depth(50.0 * q, before) == doctest::Approx(2.5 * depth(q, std::nullopt))); // never beyond bounds
}

TEST_CASE("Below a structure that moves stands the sentence that says how")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::example("mechanism");
    CHECK_THROWS_AS(femoop::analyse(model), femoop::MechanismError);
    try {
        femoop::analyse(model);
    } catch (const femoop::MechanismError& error) {
        ui::Painter painter(sheet, fonts);
        draw(painter, {.model = model, .motion = MotionChoice{error.mechanisms(), 0, "The frame sways."}},
             {.show = parse_show("labels")});
        view_test::Marks marks(fonts);
        painter.picture().draw_on(marks);
        CHECK(marks.has_text("The frame sways."));
    }
}

TEST_CASE("Imposed displacements and turns of a support are drawn clear of its reactions")
{
    const ui::Fonts fonts;
    femoop::Model model = view_test::simple_beam(L, q);
    for (femoop::Node& node : model.nodes) node.support->kind = femoop::SupportKind::Fixed;
    model.load_cases[0].settlements.push_back(
        {.node = femoop::NodeId{0},
         .components = {{femoop::Dof::ux, 0.001}, {femoop::Dof::uy, -0.01}, {femoop::Dof::rz, 0.002}}});
    DrawOptions options{.show = parse_show("loads,reactions")};
    const view_test::Marks marks = marks_of(model, options, fonts);
    const ui::Theme theme(options.theme);
    const auto is_imposed = [&](const auto& line) { return line.stroke.dash == ui::DashPattern{4.0, 3.0}; };
    CHECK(std::count_if(marks.lines.begin(), marks.lines.end(), is_imposed) == 3);
    for (const auto& imposed : marks.lines) {
        if (!is_imposed(imposed)) continue;
        for (const auto& reaction : marks.lines) {
            if (reaction.stroke.color != theme.stroke(ui::Role::Reaction).color) continue;
            for (const ui::Point a : imposed.points)
                for (std::size_t i = 0; i + 1 < reaction.points.size(); ++i) {
                    const ui::OrientedBox around(a, {10.0, 10.0});
                    CHECK(!around.meets_segment(reaction.points[i], reaction.points[i + 1]));
                }
        }
    }
}

namespace {

/// Widths of the beam on the sheets of its panels, as shares of a panel's width.
double drawn_share(ui::Size size, ui::ThemeName theme, std::string_view show, int n_columns)
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    const DrawOptions options{.show = parse_show(show), .theme = theme};
    const Camera camera = fitted_camera({model, &results}, options, size, fonts);
    return 8.0 * Projection(camera).scale() * n_columns / size.width; // the beam is 8 m long
}

} // namespace

TEST_CASE("With many panels on the projector the structure still takes half of its panel's width")
{
    CHECK(drawn_share({1280.0, 800.0}, ui::ThemeName::Projector, "loads,reactions,labels,N,V,M,deformed", 3) > 0.5);
    CHECK(drawn_share({1920.0, 1080.0}, ui::ThemeName::Projector, "loads,reactions,labels,N,V,M,deformed", 3) > 0.5);
}

TEST_CASE("A result that a kind of model does not have gets no panel")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::example("grillage"); // it has no N
    const view_test::Marks marks = marks_of(model, {.show = parse_show("loads,labels,N,M")}, fonts);
    CHECK(marks.has_text("Loads"));
    CHECK(!marks.has_text("Structure"));
}

TEST_CASE("Both areas of a straight shear force have their sign, a third of the way from the support to the zero")
{
    const ui::Fonts fonts;
    const view_test::Marks marks = marks_of(view_test::simple_beam(L, q), {.show = {Show::V}}, fonts);
    std::vector<double> signs;
    for (const auto& disc : marks.discs)
        if (disc.radius == 6.0) signs.push_back(disc.center.x);
    REQUIRE(signs.size() == 2);
    double left = 1e9, right = 0.0;
    for (const auto& line : marks.lines)
        for (const ui::Point p : line.points) left = std::min(left, p.x), right = std::max(right, p.x);
    CHECK(signs[1] - signs[0] == doctest::Approx((right - left) * 2.0 / 3.0).epsilon(0.1));
}

TEST_CASE("A section without Iy deforms in the plane as any other, and its largest displacement is told")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::simple_beam(L, q); // gives A and Iz alone
    const femoop::LocalDisplacement d =
        femoop::analyse(model)[femoop::CaseId{}].curve(femoop::MemberId{}).displacement(2.0);
    CHECK(d.v < 0.0);
    CHECK(d.w == 0.0);
    const view_test::Marks marks = marks_of(model, {.show = parse_show("deformed,values")}, fonts);
    const double sag = 5.0 * q * std::pow(L, 4) / (384.0 * 210e6 * 2.0e-4); // 5 q L^4 / 384 E I
    CHECK(sag * 1000.0 == doctest::Approx(8.932).epsilon(1e-4));
    CHECK(marks.has_text("δ = 8.932 mm"));
}

TEST_CASE("Dimension lines of a structure in space lie on the sheet, however far from its nodes")
{
    const ui::Fonts fonts;
    femoop::Model model = view_test::example("bent_cantilever");
    model.nodes[2].at = {model.nodes[1].at[0], model.nodes[1].at[1] - 2.0, 0.0}; // bent to the other side
    const femoop::Results results = femoop::analyse(model);
    DrawOptions options{.show = parse_show("loads,reactions,labels,dimensions"), .theme = ui::ThemeName::Projector};
    ui::Painter painter({640.0, 720.0}, fonts);
    draw(painter, {model, &results}, options);
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    int n_lines = 0;
    for (const auto& line : marks.lines) {
        if (line.stroke.color != ui::Theme(options.theme).stroke(ui::Role::Dimension).color) continue;
        ++n_lines;
        for (const ui::Point p : line.points) CHECK(painter.sheet().contains(p));
    }
    CHECK(n_lines >= 6); // two lines with two ticks each, of two strokes
}

TEST_CASE("An envelope is of the cases that are not left out; of all where none would be left")
{
    femoop::Model model = view_test::simple_beam(L, q);
    model.load_cases.push_back(model.load_cases.front());
    model.load_cases.back().id = "Q";
    model.combinations.push_back({"U", {{femoop::CaseId(0), 1.35}, {femoop::CaseId(1), 1.5}}});
    DrawOptions options;
    CHECK(envelope_cases(model, options).size() == 3);
    CHECK(envelope_text(model, options) == "Envelope of all cases");
    options.left_out = {"Q", "a case that the model lacks"};
    CHECK(envelope_cases(model, options) == std::vector{femoop::CaseId(0), femoop::CaseId(2)});
    CHECK(envelope_text(model, options) == "Envelope of " + model.load_cases.front().id + ", U");
    options.left_out = {model.load_cases.front().id, "Q", "U"};
    CHECK(envelope_cases(model, options).size() == 3);
}

TEST_CASE("The extremes of a band and the ranges of reactions are written with the case that governs")
{
    const ui::Fonts fonts;
    femoop::Model model = view_test::simple_beam(L, q);
    model.load_cases.front().id = "G";
    model.combinations.push_back({"U", {{femoop::CaseId(0), 1.35}}});
    const DrawOptions options{.show = {Show::M, Show::Reactions, Show::Values}, .is_envelope = true};
    const view_test::Marks marks = marks_of(model, options, fonts);
    CHECK(marks.has_text("99.23 (U)"));               // 1.35 q L^2 / 8
    CHECK(marks.has_text("fy 42 (G) … 56.7 (U) kN")); // q L / 2
}

TEST_CASE("An envelope of a model without cases is the structure alone")
{
    femoop::Model model = view_test::simple_beam(L, q);
    model.load_cases.clear();
    const ui::Fonts fonts;
    const DrawOptions options{.show = {Show::M, Show::Reactions, Show::Values}, .is_envelope = true};
    const view_test::Marks marks = marks_of(model, options, fonts);
    CHECK(!marks.has_text("kN"));
}

TEST_CASE("The largest value of an envelope is written exactly where a place beside it has nearly the same")
{
    // A span l with an overhang a: the largest moment is p x^2 / 2 at x = l / 2 - a^2 / (2 l), hardly more than at 3.75.
    constexpr double span = 10.0, load = 1.0002, x = 3.785;
    const ui::Fonts fonts;
    FrameMaker made;
    made.node("A", 0, 0, femoop::SupportKind::Pin).node("B", span, 0, femoop::SupportKind::Roller);
    made.node("C", span + std::sqrt(span * span - 2.0 * span * x), 0).member("A", "B").member("B", "C");
    made.uniform("AB", -load).uniform("BC", -load);
    const DrawOptions options{.show = {Show::M, Show::Values}, .is_envelope = true};
    const view_test::Marks marks = marks_of(made.model, options, fonts);
    CHECK(marks.has_text("7.165"));
    CHECK_FALSE(marks.has_text("7.164"));
}

TEST_CASE("The band of an envelope has the extremes of all cases")
{
    femoop::Model model = view_test::simple_beam(L, q);
    femoop::LoadCase lifted = model.load_cases.front();
    lifted.id = "lifted";
    std::get<femoop::DistributedLoad>(lifted.members.front().load).values.front().start = femoop::Quantity(0.5 * q);
    model.add(lifted);
    const ui::Fonts fonts;
    const DrawOptions options{.show = {Show::M, Show::Values}, .is_envelope = true};
    const view_test::Marks marks = marks_of(model, options, fonts);
    const femoop::Envelope envelope(femoop::analyse(model));
    const femoop::GoverningExtremes extremes = envelope.extremes(femoop::MemberId(0), MemberComponent::Mz);
    CHECK(extremes.max.value == doctest::Approx(q * L * L / 8.0));
    CHECK(extremes.min.value == doctest::Approx(-0.5 * q * L * L / 8.0));
    const ui::DisplayUnits units = display_units(model, options);
    const auto says = [&](double value) {
        const std::string wanted = units.number(std::abs(value), ui::Measure::Moment);
        return std::ranges::any_of(marks.texts,
                                   [&](const auto& text) { return text.words.starts_with(wanted + " ("); });
    };
    CHECK(says(extremes.max.value));
    CHECK(says(extremes.min.value));
}

TEST_CASE("What results are compared with has its members behind, faint, where they lie elsewhere now, and there alone")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::example("portal");
    const femoop::Results results = femoop::analyse(model);
    femoop::Model taller = model;
    for (const char* node : {"B", "C"}) taller.nodes[taller.find_node(node)->index].at[1] = femoop::Quantity(5.5);
    const auto n_faint_members = [&](const femoop::Model& other) {
        const ReferenceResults reference{.model = other, .results = femoop::analyse(other)};
        ui::Painter painter(sheet, fonts);
        draw(painter, {.model = model, .results = &results, .reference = &reference}, {.show = {Show::N, Show::M}});
        view_test::Marks marks(fonts);
        painter.picture().draw_on(marks);
        const ui::Color faint = ui::with_opacity(ui::Theme(ui::ThemeName::Light).stroke(ui::Role::Member).color, 0.5);
        return std::ranges::count(marks.lines, faint, [](const auto& line) { return line.stroke.color; });
    };
    CHECK(n_faint_members(model) == 0);
    const auto n_panels = n_faint_members(taller) / static_cast<std::ptrdiff_t>(model.members.size());
    CHECK(n_panels >= 1);
    CHECK(n_faint_members(taller) == n_panels * static_cast<std::ptrdiff_t>(model.members.size())); // all three moved
}

TEST_SUITE_END();
