// Golden pictures of a pupil's sheet: empty, on the way with mistakes, solved; beams and frames.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "apps/cross/document/file.h"
#include "apps/cross/view/numbers.h"
#include "apps/cross/view/scene.h"
#include "tests/apps/cross/strings.h"
#include "tests/golden/scene.h"

using namespace cross;
namespace fc = femoop::cross;

TEST_SUITE_BEGIN("pictures");

namespace {

struct ExerciseShot {
    std::size_t n_filled = 0; ///< cells with what belongs there
    std::vector<std::pair<std::size_t, std::string>> written{};
    std::size_t stage = 0;
    std::optional<fc::BlankId> cell{};
    Look look{};
    ui::Size size{1000.0, 760.0};
};

Document exercise(fc::Difficulty difficulty, std::uint32_t seed)
{
    Document document{.model = fc::seeded_model(difficulty, seed)};
    document.pupil = Pupil{.seeded = Seeded{difficulty, seed}};
    return document;
}

void check_exercise(const std::string& name, Document document, const ExerciseShot& shot)
{
    const Solution solution = solve(document);
    REQUIRE(solution.task);
    std::optional<Worksheet> worksheet = worksheet_of(document);
    REQUIRE(worksheet);
    std::vector<std::string>& cells = document.pupil->written;
    cells.resize(worksheet->form.blanks.size());
    for (const auto& [at, text] : shot.written) cells[at] = text;
    judge_again(*worksheet, document);
    const ui::DisplayUnits units = units_of(document.model, shot.look.tr);
    for (std::size_t i = 0; i < std::min(shot.n_filled, cells.size()); ++i) {
        if (!cells[i].empty() || worksheet->form.blanks[i].may_stay_empty) continue;
        cells[i] = text_for(*worksheet, fc::BlankId(i), units);
        judge_again(*worksheet, document);
    }
    const femoop::Results* const state = worksheet->is_solved() && solution.task->balanced ? &*solution.task->balanced
                                                                                           : nullptr;
    const ui::Theme theme(shot.look.theme);
    golden::check_scene(name, {.size = shot.size, .background = theme.background()}, [&](ui::Painter& painter) {
        draw(painter, {document, solution, state, 1.0, {}, shot.look, &*worksheet, shot.cell, shot.stage});
    });
}

} // namespace

namespace {

/// What a swaying portal's empty sheet shows on the projector.
Drawn drawn_exercise(ui::Size size, const Zoom& zoom)
{
    Document document = exercise(fc::Difficulty::SwayFrame, 1);
    const Solution solution = solve(document);
    const std::optional<Worksheet> worksheet = worksheet_of(document);
    REQUIRE(worksheet);
    Look look{.theme = ui::ThemeName::Projector, .zoom = zoom};
    const ui::Fonts fonts;
    ui::Painter painter(size, fonts);
    return draw(painter, {document, solution, nullptr, 1.0, {}, look, &*worksheet});
}

} // namespace

TEST_CASE("Cells of a portal's feet stand beside them, as high as the projector's type")
{
    for (const ui::Size size : {ui::Size{1280.0, 740.0}, ui::Size{1920.0, 1010.0}}) {
        CAPTURE(size.width);
        const Drawn drawn = drawn_exercise(size, {});
        const Document document = exercise(fc::Difficulty::SwayFrame, 1);
        const Worksheet worksheet = *worksheet_of(document);
        const auto cells_of = [&](const std::string& end) {
            std::optional<ui::Box> all;
            for (const CellMark& mark : drawn.cells) {
                const fc::Blank& blank = worksheet.form[mark.cell];
                if (worksheet.form.problem[blank.end].label != end) continue;
                CHECK(mark.box.height() > 20.0);
                all = all ? ui::united(*all, mark.box) : mark.box;
            }
            REQUIRE(all);
            return *all;
        };
        const Drawn::View& sheet = drawn.views.back();
        for (const char* const end : {"AB", "DC"}) {
            CAPTURE(end);
            const double foot = sheet.box.min.y + sheet.camera.to_sheet({0.0, 0.0}).y;
            CHECK(foot - cells_of(end).max.y < 60.0);
        }
    }
}

TEST_CASE("Cells of a beam stand beside their joints, below it or above")
{
    for (const fc::Difficulty difficulty : {fc::Difficulty::Overhang, fc::Difficulty::SeveralSpans})
        for (const std::uint32_t seed : {1U, 2U, 3U})
            for (const ui::ThemeName theme : {ui::ThemeName::Light, ui::ThemeName::Projector})
                for (const ui::Size size : {ui::Size{632.0, 740.0}, ui::Size{900.0, 540.0}, ui::Size{1280.0, 740.0}}) {
                    CAPTURE(seed);
                    CAPTURE(size.width);
                    const Document document = exercise(difficulty, seed);
                    const Solution solution = solve(document);
                    const std::optional<Worksheet> worksheet = worksheet_of(document);
                    REQUIRE(worksheet);
                    const Look look{.theme = theme};
                    const ui::Fonts fonts;
                    ui::Painter painter(size, fonts);
                    const Drawn drawn = draw(painter, {document, solution, nullptr, 1.0, {}, look, &*worksheet});
                    const Drawn::View& sheet = drawn.views.back();
                    const double beam = sheet.box.min.y + sheet.camera.to_sheet({0.0, 0.0}).y;
                    std::map<std::size_t, double> gaps;
                    for (const CellMark& mark : drawn.cells) {
                        const std::size_t end = worksheet->form[mark.cell].end.index;
                        const double gap = std::min(std::abs(mark.box.min.y - beam), std::abs(mark.box.max.y - beam));
                        const auto least = gaps.try_emplace(end, gap).first;
                        least->second = std::min(least->second, gap);
                        CHECK(mark.box.max.y < sheet.box.max.y);
                    }
                    for (const auto& [end, gap] : gaps) CHECK(gap < 75.0);
                }
}

TEST_CASE("Between the projector's panels every cell of a beam with an overhang is seen, as high as the panels' text")
{
    for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U}) {
        CAPTURE(seed);
        const Document document = exercise(fc::Difficulty::Overhang, seed);
        const Solution solution = solve(document);
        const std::optional<Worksheet> worksheet = worksheet_of(document);
        REQUIRE(worksheet);
        const Look look{.theme = ui::ThemeName::Projector};
        const ui::Fonts fonts;
        ui::Painter painter({622.0, 742.0}, fonts);
        const Drawn drawn = draw(painter, {document, solution, nullptr, 1.0, {}, look, &*worksheet});
        CHECK(drawn.cells.size() == worksheet->form.blanks.size());
        for (const CellMark& mark : drawn.cells) {
            CHECK(mark.box.height() >= 1.2 * look.full_theme().type().normal);
            CHECK(drawn.views.back().box.contains(mark.box));
        }
    }
}

TEST_CASE("No stiffness of an exercise's spans is written under the heading of its sheet")
{
    const ui::Fonts fonts;
    for (const fc::Difficulty difficulty : {fc::Difficulty::Overhang, fc::Difficulty::SeveralSpans})
        for (const ui::Size size : {ui::Size{900.0, 540.0}, ui::Size{1280.0, 740.0}}) {
            CAPTURE(size.width);
            const Document document = exercise(difficulty, 1);
            const Solution solution = solve(document);
            const std::optional<Worksheet> worksheet = worksheet_of(document);
            REQUIRE(worksheet);
            const Look look{.theme = ui::ThemeName::Projector, .zoom = {.factor = 1.4, .is_of_sheet = true}};
            ui::Painter painter(size, fonts);
            draw(painter, {document, solution, nullptr, 1.0, {}, look, &*worksheet});
            Strings strings(fonts);
            painter.picture().draw_on(strings);
            const auto heading = std::ranges::find_if(
                strings.all, [](const auto& string) { return string.words.starts_with("Fill the sheet"); });
            REQUIRE(heading != strings.all.end());
            for (const Strings::String& string : strings.all)
                if (string.words.ends_with("EI")) CHECK_FALSE(string.box.overlaps(heading->box));
        }
}

TEST_CASE("A zoom makes the cells of a sheet larger")
{
    const auto height = [](const Zoom& zoom) {
        return drawn_exercise({1280.0, 740.0}, zoom).cells.front().box.height();
    };
    CHECK(height({.factor = 2.0}) > 1.5 * height({}));
}

TEST_CASE("An empty sheet shows cells and loads and no number that answers")
{
    check_exercise("cross_exercise_empty", exercise(fc::Difficulty::PinnedEnd, 4), {.cell = fc::BlankId(0)});
}

TEST_CASE("Right and following and wrong cells are told apart without colours")
{
    ExerciseShot shot{.n_filled = 26, .written = {{1, "1,5"}, {9, "-36"}}};
    check_exercise("cross_exercise_midway", exercise(fc::Difficulty::SeveralSpans, 2), shot);
}

TEST_CASE("A sheet that is right shows the moments")
{
    check_exercise("cross_exercise_solved", exercise(fc::Difficulty::Overhang, 3), {.n_filled = 500});
}

TEST_CASE("In Portuguese on the projector a frame's cells are read from the last row")
{
    ExerciseShot shot{.n_filled = 14, .written = {{3, "1/2"}}, .size = {1280.0, 960.0}};
    shot.look.theme = ui::ThemeName::Projector;
    shot.look.tr = ui::Catalogue(ui::Language::Portuguese);
    check_exercise("cross_exercise_projector_pt", exercise(fc::Difficulty::Frame, 5), shot);
}

TEST_CASE("Sheets of a swaying frame are added below the last of them")
{
    check_exercise("cross_exercise_sway", exercise(fc::Difficulty::SwayFrame, 1), {.n_filled = 60, .stage = 2});
}

TEST_CASE("Printed a swaying frame's own sheet needs no colour")
{
    ExerciseShot shot{.n_filled = 40, .stage = 1};
    shot.look.theme = ui::ThemeName::Print;
    check_exercise("cross_exercise_print", exercise(fc::Difficulty::SwayFrame, 1), shot);
}

TEST_SUITE_END();
