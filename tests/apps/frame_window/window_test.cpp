// The whole window of the frame app, played by scenarios: what a person clicks, types and then sees.
#include "apps/frame/document/command.h"
#include "apps/frame/document/number.h"
#include "apps/frame/session/tabs.h"
#include "apps/frame/window/stage.h"
#include "tests/apps/frame_window/played.h"
#include "tests/golden/scene.h"
#include "ui/paint/surface/golden_text.h"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

using namespace frame;

TEST_SUITE_BEGIN("frame window");

namespace {

const std::string folder = CREMONA_SOURCE_DIR "/";

} // namespace

TEST_CASE("A click on a member shows its properties and pins the reading of its section")
{
    check_window("window_portal", opened("examples/portal.json"), R"(
        click member BC 50%
        hover pixel 600 700
        expect selection Member BC
        expect member BC M at 50% is 58.52 kN·m
    )");
}

TEST_CASE("A number that is typed changes the diagrams at once, and is one step of the history")
{
    check_window("window_edited", opened("examples/portal.json"), R"(
        click member BC 50%
        click pixel 1190 417
        key Ctrl+A
        type "-25"
        key Enter
        command view.panel.history
        hover pixel 600 700
        expect undo Change qy: Distributed load on member BC
        expect member BC M at 50% is 118.7 kN·m
    )");
}

TEST_CASE("What is no number stays in its field with the reason")
{
    check_window("window_wrong_number", opened("examples/portal.json"), R"(
        command view.theme.dark
        click member BC 50%
        click pixel 1190 417
        key Ctrl+A
        type "12 apples"
        key Enter
        hover pixel 600 700
        expect undo nothing
    )");
}

TEST_CASE("A mechanism is shown at full swing with what would hold it")
{
    check_window("window_mechanism", opened("examples/mechanism.json"), R"(
        command view.panel.problems
        expect problems 1
    )");
}

TEST_CASE("Results in tables, in Portuguese on the projector")
{
    Session session = opened("examples/portal.json");
    session.set_language(ui::Language::Portuguese);
    session.view.theme = ui::ThemeName::Projector;
    check_window("window_projector", std::move(session), R"(
        command view.panel.results
        key PageDown
        expect case Q
    )");
}

TEST_CASE("A file with faults is not opened, and the model that was open stays")
{
    Session session = opened("examples/portal.json");
    session.open(folder + "tests/fuzz/corpus/model_reader/faults.json");
    check_window("window_broken_file", std::move(session), R"(
        expect file portal.json
        expect notice faults.json was not opened; the model you had is unchanged
    )");
}

TEST_CASE("A command is found by its words")
{
    check_window("window_palette", opened("examples/truss.json"), R"(
        key Ctrl+K
        wait 0.1
        type "theme"
        wait 0.1
    )");
}

TEST_CASE("Without its panels the window is all picture")
{
    check_window("window_space", opened("tests/cases/members/F3-001.json"), R"(
        key P
        drag pixel 300 650 to pixel 350 640
        hover pixel 20 780
    )");
}

TEST_CASE("Files that are dropped on the window open in tabs of their own, and nothing that is not saved is lost")
{
    const ui::Fonts fonts;
    golden::if_drawn(
        [&] {
            ui::Offscreen context({.size = {320, 200}});
            Application application(context, fonts, opened("examples/portal.json"));
            Desk& desk = application.desk();
            desk.session.change(
                {ui::translatable("Change"), [](Document& document) { set_title(document, "Changed"); }});
            application.frame(
                {.dropped_files = {folder + "examples/truss.json", folder + "examples/gerber_beam.json"}});
            REQUIRE(n_tabs(desk) == 3);
            CHECK(desk.session.file_name() == "gerber_beam.json");
            CHECK(tab(desk, 0).model().title == "Changed");
            return context.pixels();
        },
        golden::this_machine());
}

TEST_CASE("While a number is dragged the diagrams keep their scale, and find a new one when it is let go")
{
    Session session = opened("examples/portal.json");
    const auto load = [&](Step step, double value) {
        const auto command = [value](Document& document) {
            const Part part = MemberLoadPlace{0, 0};
            set_number(document, numbers(document.model, part).front().id, femoop::Quantity{value});
        };
        session.change({ui::translatable("Change"), command, step});
    };
    const auto before = session.solution().results;
    load(Step::Drag, -13.0);
    REQUIRE(session.view.scaled_by);
    load(Step::Drag, -20.0);
    const auto moment = [](const femoop::Results& r) {
        return r[femoop::CaseId(0)].curve(femoop::MemberId(1)).forces(4.0).Mz;
    };
    CHECK(moment(*session.view.scaled_by) == moment(*before));
    session.settle();
    CHECK(!session.view.scaled_by);
}

TEST_SUITE_END();
