// Golden pictures of moment distribution: beams and frames, locked, on the way and balanced, themes and languages.
#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "apps/cross/document/file.h"
#include "apps/cross/view/scene.h"
#include "apps/cross/view/sheet_places.h"
#include "tests/golden/scene.h"
#include "ui/paint/surface/golden_text.h"

using namespace cross;
namespace fc = femoop::cross;

TEST_SUITE_BEGIN("pictures");

namespace {

struct Shot {
    std::size_t n_turns = 0;
    std::size_t stage = 0;
    double phase = 1.0;
    Look look{};
    ui::Size size{1000.0, 760.0};
    std::optional<fc::JointId> hover{};
};

Document example(const std::string& name) { return read_document_file("examples/" + name + ".json"); }

void check(const std::string& name, Document document, const Shot& shot)
{
    Solution solution = solve(document);
    document.stage = shot.stage;
    if (solution.task) document.plays.resize(solution.task->n_sheets());
    for (std::size_t i = 0; i < shot.n_turns; ++i) {
        document.plays[shot.stage].take(*next_turn(document, solution));
        work(solution, document);
    }
    std::optional<femoop::Results> state;
    if (solution.task)
        state = fc::state_results(document.model, solution.task->problem,
                                  present_locks(document, solution, shot.phase));
    const ui::Theme theme(shot.look.theme);
    golden::check_scene(name, {.size = shot.size, .background = theme.background()}, [&](ui::Painter& painter) {
        draw(painter, {document, solution, state ? &*state : nullptr, shot.phase, shot.hover, shot.look});
    });
}

Document portal(const char* load_case)
{
    Document document = example("portal");
    document.method.load_case = *document.model.find_case(load_case);
    return document;
}

} // namespace

TEST_CASE("What lies under the pointer stays there while the pictures zoom and 200 times is the most")
{
    const Eigen::Vector2d own(10.0, 3.0), at(4.0, 2.0);
    const Zoom twice = zoomed({}, own, at, 2.0);
    const auto distance = [&](const Zoom& zoom) -> Eigen::Vector2d {
        return zoom.factor * (at - zoom.middle.value_or(own));
    };
    CHECK(distance(twice).isApprox(distance({})));
    CHECK(distance(zoomed(twice, own, at, 1e9)).isApprox(distance({})));
    CHECK(zoomed(twice, own, at, 1e9).factor == Zoom::most);
    CHECK(moved(twice, own, {1.0, 0.5}).middle->isApprox(*twice.middle - Eigen::Vector2d(1.0, 0.5)));
}

TEST_CASE("A locked beam has its fixed-end moments and a lock on every joint")
{
    check("cross_locked", starting_document(), {});
}

TEST_CASE("Each balance is underlined and the last turn stands out")
{
    check("cross_midway", starting_document(), {.n_turns = 3, .hover = fc::JointId(0)});
}

TEST_CASE("A joint half turned carries nothing over yet")
{
    check("cross_turning", starting_document(), {.n_turns = 2, .phase = 0.45});
}

TEST_CASE("Carry-overs fly along the members from near end to far end")
{
    check("cross_carrying", starting_document(), {.n_turns = 2, .phase = 0.85});
}

TEST_CASE("A balanced beam has lost its oldest rows where there was no room")
{
    check("cross_balanced", starting_document(), {.n_turns = 11, .size = {1000.0, 640.0}});
}

TEST_CASE("A portal's props hold it while the loads are distributed")
{
    check("cross_portal_loads", portal("W"), {.n_turns = 3});
}

TEST_CASE("A sway alone has fixed-end moments in the columns")
{
    check("cross_portal_sway", portal("W"), {.n_turns = 2, .stage = 1});
}

TEST_CASE("All sheets together have no locks") { check("cross_portal_together", portal("W"), {.stage = 2}); }

TEST_CASE("The head of a column is no broader than the column, whatever its nodes are called")
{
    Document document = example("portal");
    document.model.nodes[0].id = "Apoio esquerdo";
    document.model.nodes[1].id = "Nó central";
    const Solution solution = solve(document);
    REQUIRE(solution.task);
    const ui::Fonts fonts;
    const ui::Painter painter({100.0, 100.0}, fonts);
    const ui::TextStyle style{.size = 12.0};
    for (const double width : {58.0, 90.0, 250.0})
        for (const fc::End& end : solution.task->problem.ends) {
            CAPTURE(end.label);
            CHECK(painter.measure(head_within(painter, document.model, end, style, width), style).width <= width);
        }
    const fc::End& foot = solution.task->problem.ends[0];
    CHECK(foot.label == "Apoio esquerdo-Nó central");
    CHECK(head_within(painter, document.model, foot, style, 250.0) == foot.label);
    CHECK(head_within(painter, document.model, foot, style, 90.0) == "Apoi…-Nó c…");
}

TEST_CASE("Half of a symmetric portal is written left of the axis, and the sums stand on both sides")
{
    Document document = example("portal");
    document.method.extent = fc::Extent::Half;
    check("cross_half", document, {.n_turns = 1});
}

TEST_CASE("In Portuguese on the projector the sheet is read from the last row")
{
    Look look;
    look.theme = ui::ThemeName::Projector;
    look.tr = ui::Catalogue(ui::Language::Portuguese);
    check("cross_projector_pt", starting_document(), {.n_turns = 4, .look = look, .size = {1280.0, 960.0}});
}

TEST_CASE("Printed the sheet needs no colour")
{
    Look look;
    look.theme = ui::ThemeName::Print;
    check("cross_print", example("continuous_beam"), {.n_turns = 3, .look = look});
}

namespace {

/// Where a word stands in the structure's picture of a portal; nothing where it does not.
std::optional<ui::Box> box_of(const std::string& text, const Drawn& drawn)
{
    const auto found = std::ranges::find(drawn.texts, text, &WrittenText::text);
    return found == drawn.texts.end() ? std::nullopt : std::optional(found->box);
}

} // namespace

TEST_CASE("A portal's load is written below the heading in every window, and its lengths whole")
{
    const Document document = portal("G");
    const Solution solution = solve(document);
    const ui::Fonts fonts;
    for (const ui::ThemeName theme : {ui::ThemeName::Light, ui::ThemeName::Projector})
        for (const ui::Size size : {ui::Size{630.0, 720.0}, ui::Size{1280.0, 720.0}, ui::Size{1920.0, 1000.0}}) {
            CAPTURE(size.width);
            Look look;
            look.theme = theme;
            ui::Painter painter(size, fonts);
            const Drawn drawn = draw(painter, {document, solution, nullptr, 1.0, {}, look});
            const auto heading = box_of("Structure and loads: G", drawn), load = box_of("12 kN/m", drawn);
            REQUIRE(heading);
            REQUIRE(load);
            CHECK(load->min.y > heading->center().y);
            for (const drawing::LoadMark& mark : drawn.loads)
                for (const ui::Point& at : mark.area) CHECK(at.y > heading->max.y);
            for (const char* const length : {"4.5 m", "8 m"}) {
                CAPTURE(length);
                REQUIRE(box_of(length, drawn));
                CHECK(drawn.views.front().box.contains(box_of(length, drawn)->min));
                CHECK(drawn.views.front().box.contains(box_of(length, drawn)->max));
            }
        }
}

TEST_CASE("The numbers of a beam's sheet grow with the wheel, on the projector too")
{
    const auto size_of_factor = [](const Zoom& zoom) {
        const Document document = starting_document();
        const Solution solution = solve(document);
        const Look look{.theme = ui::ThemeName::Projector, .zoom = zoom};
        const ui::Fonts fonts;
        ui::Painter painter({1280.0, 690.0}, fonts);
        draw(painter, {document, solution, nullptr, 1.0, {}, look});
        std::istringstream lines(ui::golden_text(painter.picture())); // (120.0, 46.5) center 13 "0.360"
        for (std::string line, word; std::getline(lines, line);) {
            if (!line.ends_with("\"0.360\"")) continue;
            std::istringstream words(line);
            double size = 0.0;
            words >> word >> word >> word >> size;
            return size;
        }
        return 0.0;
    };
    REQUIRE(size_of_factor({}) > 0.0);
    CHECK(size_of_factor({.factor = 2.0}) > 1.7 * size_of_factor({}));
}

TEST_CASE("In a narrow picture the forces of two props are written at its foot, named by their nodes")
{
    const Document document = read_document_file("tests/cases/own/staged-two-storeys.json");
    const Solution solution = solve(document);
    const auto state = fc::state_results(document.model, solution.task->problem,
                                         present_locks(document, solution, 1.0));
    const ui::Fonts fonts;
    const auto drawn_at = [&](ui::Size size) {
        ui::Painter painter(size, fonts);
        draw(painter, {document, solution, &state, 1.0, {}, {}});
        return ui::golden_text(painter.picture());
    };
    for (const std::string force : {"C  −17.5 kN", "E  −12.5 kN"}) {
        CAPTURE(force);
        CHECK(drawn_at({443.0, 525.0}).find(force) != std::string::npos);
        CHECK(drawn_at({1280.0, 700.0}).find(force) == std::string::npos);
    }
}

TEST_CASE("In fractions factors and moments are exact")
{
    Look look;
    look.fractions = true;
    check("cross_fractions", starting_document(), {.n_turns = 2, .look = look});
}

TEST_CASE("Shears and reactions of a state with locked joints stand where the moments were")
{
    Look look;
    look.shears = true;
    check("cross_shears", starting_document(), {.n_turns = 2, .look = look});
}

TEST_CASE("By the tension side both ends of a joint have one sign")
{
    Look look;
    look.signs = Signs::TensionSide;
    look.theme = ui::ThemeName::Dark;
    check("cross_tension_side", starting_document(), {.n_turns = 5, .look = look});
}

TEST_CASE("What cannot be distributed is said in place of the pictures")
{
    check("cross_refused", example("grillage"), {});
}

TEST_SUITE_END();
