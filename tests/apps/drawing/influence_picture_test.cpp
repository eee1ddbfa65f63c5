// Influence lines as pictures.
#include "apps/drawing/results/influence_picture.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "apps/drawing/draw.h"
#include "apps/drawing/results/train_picture.h"
#include "apps/drawing/sheet/subject.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/result/components.h"
#include "tests/apps/drawing/view_model.h"
#include "tests/golden/scene.h"

using namespace drawing;
using femoop::MemberComponent;
using femoop::MovingEffect;

namespace {

MovingEffect section_force(const femoop::Model& model, std::string_view member, MemberComponent component, double x)
{
    return {.quantity = femoop::ExpectedQuantity::SectionForce,
            .member = model.find_member(member),
            .component = component,
            .at = femoop::Quantity(x)};
}

InfluencePicture picture_of(const femoop::Model& model, const std::vector<femoop::MemberId>& members,
                            const MovingEffect& effect, const std::vector<femoop::Component>& load = {})
{
    femoop::influence::InfluenceAnalysis analysis(model);
    InfluencePicture picture{.path = femoop::influence::lay_out(model, members),
                             .load = femoop::influence::unit_load(model.analysis, load),
                             .line = {}};
    picture.line = analysis.line(picture.path, picture.load, effect);
    picture.motion = analysis.motion(effect);
    return picture;
}

DrawOptions line_alone()
{
    DrawOptions options;
    options.show = labels;
    options.show.insert(Show::Influence);
    return options;
}

view_test::Marks marks_of(const femoop::Model& model, const InfluencePicture& picture, const ui::Fonts& fonts,
                          ui::Size sheet = {800.0, 500.0})
{
    ui::Painter painter(sheet, fonts);
    draw(painter, {.model = model, .influence = &picture}, line_alone());
    view_test::Marks marks(fonts);
    painter.picture().draw_on(marks);
    return marks;
}

/// Two level lines, one far below the other from end to end: the beam, and the part of the axis where it is.
bool has_path_below_itself(const view_test::Marks& marks)
{
    constexpr double near = 0.5, apart = 50.0, least_width = 200.0; // [px]
    const auto is_level = [](const view_test::Marks::Line& line) {
        return line.points.size() == 2 && std::abs(line.points[0].y - line.points[1].y) < near &&
               std::abs(line.points[0].x - line.points[1].x) > least_width;
    };
    const auto is_below = [&](const view_test::Marks::Line& a, const view_test::Marks::Line& b) {
        return is_level(a) && is_level(b) && std::abs(a.points[0].x - b.points[0].x) < near &&
               std::abs(a.points[1].x - b.points[1].x) < near && a.points[0].y > b.points[0].y + apart;
    };
    return std::ranges::any_of(marks.lines, [&](const auto& a) {
        return std::ranges::any_of(marks.lines, [&](const auto& b) { return is_below(a, b); });
    });
}

double height_of(const view_test::Marks& marks, std::string_view words)
{
    const auto found = std::ranges::find(marks.texts, words, &view_test::Marks::Text::words);
    REQUIRE(found != marks.texts.end());
    return found->box.min.y;
}

constexpr double L = 8.0, a = 2.0; // of the beam, and of the section from its left end
const std::vector<femoop::MemberId> beam{femoop::MemberId(0)};

} // namespace

TEST_CASE("Positive ordinates stand on the side to which the load points")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::simple_beam(L, 1.0);
    const MovingEffect M = section_force(model, "AB", MemberComponent::Mz, a);
    const std::string ordinate = "1.5"; // a (L - a) / L
    const view_test::Marks down = marks_of(model, picture_of(model, beam, M), fonts);
    CHECK(height_of(down, ordinate) > height_of(down, "A"));
    const view_test::Marks up = marks_of(model, picture_of(model, beam, M, {{.dof = femoop::Dof::uy, .value = 1.0}}),
                                         fonts);
    CHECK(height_of(up, "−1.5") > height_of(up, "A")); // negative, so on the side from which the load comes
}

TEST_CASE("Ordinates stand along the load over inclined members, and square to those that it points along")
{
    const Eigen::Vector3d origin = Eigen::Vector3d::Zero(), down = -Eigen::Vector3d::UnitY();
    const femoop::NodeVector load = femoop::influence::unit_load(femoop::AnalysisKind::Frame2d, {});
    for (const double degrees : {-70.0, -30.0, 0.0, 45.0, 70.0, 80.0, 90.0, 135.0}) {
        CAPTURE(degrees);
        const double angle = degrees * std::numbers::pi / 180.0;
        const Eigen::Vector3d end(std::cos(angle), std::sin(angle), 0.0);
        const auto member = femoop::member_geometry(femoop::AnalysisKind::Frame2d, origin, end, origin);
        const Eigen::Vector3d side = ordinate_side(load, member, true);
        CHECK(side.norm() == doctest::Approx(1.0));
        const bool is_steep = std::abs(std::cos(angle)) < 0.25;
        CHECK((is_steep ? std::abs(side.dot(end)) : (side - down).norm()) == doctest::Approx(0.0));
    }
}

TEST_CASE("The head tells extremes, their places, and the areas of either sign")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::simple_beam(L, 1.0);
    const MovingEffect V = section_force(model, "AB", MemberComponent::Vy, a);
    const view_test::Marks marks = marks_of(model, picture_of(model, beam, V), fonts);
    CHECK(marks.has_text("Influence line of V(AB, 2 m)"));
    // (L - a) / L and -a / L at the section; triangles of (L - a)^2 / 2L and a^2 / 2L
    CHECK(marks.has_text("max 0.75 at s = 2 m  ·  min −0.25 at s = 2 m  ·  areas +2.25, −0.25 m"));
}

TEST_CASE("Where an extreme stands at several places the head names two of them, and how many there are more")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::simple_beam(L, 1.0);
    const MovingEffect M = section_force(model, "AB", MemberComponent::Mz, a);
    InfluencePicture picture = picture_of(model, beam, M);
    const auto head_of = [&](const std::vector<double>& ordinates) { // a zigzag
        const double length = L / static_cast<double>(ordinates.size() - 1);
        picture.line.ordinates.pieces.clear();
        for (std::size_t i = 0; i + 1 < ordinates.size(); ++i) {
            const double from = length * static_cast<double>(i);
            picture.line.ordinates.pieces.push_back(
                {from, from + length, {ordinates[i], (ordinates[i + 1] - ordinates[i]) / length}});
        }
        return marks_of(model, picture, fonts);
    };
    CHECK(head_of({0.0, 3.0, -2.0, 3.0, 0.0})
              .has_text("max 3 m at s = 2 m, 6 m  ·  min −2 m at s = 4 m  ·  areas +9.6, −1.6 m²"));
    CHECK(head_of({0.0, 3.0, 0.0, 3.0, 0.0, 3.0, 0.0, 3.0, 0.0})
              .has_text("max 3 m at s = 1 m, 3 m and 2 more  ·  areas +12 m²"));
    CHECK(head_of({0.0, 3.0, 3.0, 0.0, 0.0}).has_text("max 3 m at s = 2 m to 4 m  ·  areas +12 m²"));
}

TEST_CASE("A train's sum is said with its curve, where it stands and where it is critical; a low sheet has no curve")
{
    const ui::Fonts fonts;
    const femoop::Model model = view_test::simple_beam(L, 1.0);
    InfluencePicture picture = picture_of(model, beam, section_force(model, "AB", MemberComponent::Mz, a));
    StandingTrain standing{.name = "cart", .train = {.axles = {12.0, 20.0}, .spacings = {{3.0, 3.0}}}};
    const femoop::influence::TrainSearch search(picture.line.ordinates, {0.0, L}, standing.train);
    standing.placing = search.at({.position = 6.0}, standing.kind);
    standing.is_worst = false;
    stand_on(picture, standing);
    picture.sentences = train_sentences(model, {}, picture, standing);
    CHECK(picture.sentences == std::vector<std::string>{"M(AB, 2 m) = 31 kN·m under cart: leading axle at s = 6 m",
                                                        "= 12 × 0.5 + 20 × 1.25"});
    const auto worst = search.largest(); // 12 (8 - 5) / 4 + 20 · 1.5 with the second axle at the section
    CHECK(worst.value == doctest::Approx(39.0));
    picture.curve = {.runs = {{search.over_positions(standing.kind, false), 0.0, L + 3.0}},
                     .worst = PositionCurve::Place{*worst.position, worst.value},
                     .now = {6.0, standing.placing.value},
                     .path_length = L};
    const view_test::Marks marks = marks_of(model, picture, fonts);
    CHECK(marks.has_text("31 kN·m  (s = 6 m)"));
    CHECK(marks.has_text("critical: 39 kN·m  (s = 5 m)"));
    CHECK(!marks_of(model, picture, fonts, {800.0, 300.0}).has_text("31 kN·m  (s = 6 m)"));
    CHECK(has_path_below_itself(marks));
    picture.curve->runs.front().to = 3.0 * L; // of a train that is longer than half the beam
    CHECK(!has_path_below_itself(marks_of(model, picture, fonts)));
}

TEST_CASE("Ordinates are counted in the effect's unit by the load's")
{
    const femoop::Model model = view_test::simple_beam(L, 1.0);
    const ui::DisplayUnits units = display_units(model, {});
    const std::vector<femoop::Component> couple{{.dof = femoop::Dof::rz, .value = 1.0}};
    const auto name = [&](const MovingEffect& effect, const std::vector<femoop::Component>& load = {}) {
        return ordinate_unit(units, {.path = {},
                                     .load = femoop::influence::unit_load(model.analysis, load),
                                     .line = {effect, {}, {}, {}}})
            .name;
    };
    const MovingEffect M = section_force(model, "AB", MemberComponent::Mz, a),
                       V = section_force(model, "AB", MemberComponent::Vy, a);
    const MovingEffect v = section_force(model, "AB", MemberComponent::v, a);
    CHECK(name(M) == "m");
    CHECK(name(V) == "");
    CHECK(name(v) == "mm/kN");
    CHECK(name(M, couple) == "");
    CHECK(name(V, couple) == "1/m");
}

TEST_SUITE("influence pictures")
{
    void check_line(const std::string& name, const femoop::Model& model, const InfluencePicture& picture,
                    const DrawOptions& options)
    {
        golden::check_scene(
            name, {.size = {1000.0, 600.0}, .background = background(options)},
            [&](ui::Painter& painter) { draw(painter, {.model = model, .influence = &picture}, options); });
    }

    TEST_CASE("influence_moment: M in the middle span of three")
    {
        const femoop::Model model = view_test::example("influence");
        const auto& asked = model.moving_loads.influence_lines.front();
        check_line("influence_moment", model,
                   picture_of(model, femoop::influence::members_of(model, asked.path), asked.effect), line_alone());
    }

    TEST_CASE("influence_sway: a portal sways as the shear force of its beam is released, on the projector")
    {
        const femoop::Model model = view_test::example("portal");
        DrawOptions options = line_alone();
        options.theme = ui::ThemeName::Projector;
        check_line("influence_sway", model,
                   picture_of(model, {*model.find_member("BC")}, section_force(model, "BC", MemberComponent::Vy, 3.0)),
                   options);
    }
}

namespace {

/// How many of so many kept lines are shown on a sheet, and how high the lowest panel is.
struct KeptLines {
    KeptLines(const femoop::Model& model, std::size_t n, ui::Size sheet)
    {
        const ui::Fonts fonts;
        const std::vector<femoop::MemberId> first{femoop::MemberId(0)};
        const MovingEffect effect{.quantity = femoop::ExpectedQuantity::SectionForce,
                                  .member = femoop::MemberId(0),
                                  .component = femoop::section_force_components(model.analysis).back(),
                                  .at = femoop::Percent{40.0}};
        const InfluencePicture line = picture_of(model, first, effect);
        const DrawInput input{
            .model = model, .influence = &line, .kept_lines = std::vector<const InfluencePicture*>(n, &line)};
        DrawOptions options = line_alone();
        options.theme = ui::ThemeName::Projector;
        ui::Painter painter(sheet, fonts);
        const DrawState state;
        plan = Subject(input, options, state).draw(painter).plan;
        view_test::Marks marks(fonts);
        painter.picture().draw_on(marks);
        for (const auto& text : marks.texts)
            if (text.words.starts_with("kept lines without room")) left_out = text.words;
        height = plan->panels.front().box.height();
        width = plan->panels.front().box.width();
    }

    std::optional<Subject::Plan> plan;
    std::string left_out;
    double height = 0.0, width = 0.0;
};

} // namespace

TEST_CASE("On a low sheet only so many kept lines are shown that each can be read, and the others are counted")
{
    const femoop::Model model = view_test::simple_beam(L, 1.0);
    const KeptLines low(model, 5, {900.0, 500.0}), high(model, 5, {900.0, 1200.0});
    CHECK(high.plan->panels.size() == 6);
    CHECK(high.left_out.empty());
    CHECK(low.plan->panels.size() < 6);
    CHECK(low.left_out == "kept lines without room: " + std::to_string(6 - low.plan->panels.size()));
    const double heads = 1.6 * ui::Theme(ui::ThemeName::Projector).type().normal;
    CHECK(low.height > 3.0 * heads);
    CHECK(low.width == 900.0); // one below the other
}

TEST_CASE("Kept lines of a structure in space stand in two columns where it is larger there")
{
    const KeptLines four(view_test::example("balcony"), 3, {1200.0, 600.0});
    CHECK(four.plan->panels.size() == 4);
    CHECK(four.width == 600.0);
    CHECK(four.left_out.empty());
}
