// What scenarios (tests/scenarios) cannot do: files dropped on the window, numbers looked at while they are dragged.
#include "apps/drawing/results/locked_scale.h"
#include "apps/frame/document/command.h"
#include "apps/frame/document/number.h"
#include "apps/frame/session/tabs.h"
#include "apps/frame/window/application.h"
#include "femoop/io/model_file.h"
#include "tests/apps/frame_window/opened.h"
#include "tests/golden/scene.h"
#include "tests/source_folder.h"
#include "ui/context/offscreen.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace frame;

TEST_SUITE_BEGIN("frame window");

namespace {

const std::string top_folder = source_folder() + "/";

} // namespace

TEST_CASE("Files that are dropped on the window open in tabs of their own, and nothing that is not saved is lost")
{
    const ui::Fonts fonts;
    golden::if_drawn(
        [&] {
            ui::Offscreen context({.size = {320, 200}});
            Application application(context, fonts, opened("examples/portal.json"));
            Workspace& workspace = application.workspace();
            workspace.session.change(
                {ui::translatable("Change"), [](Document& document) { set_title(document, "Changed"); }});
            application.frame(
                {.dropped_files = {top_folder + "examples/truss.json", top_folder + "examples/gerber_beam.json"}});
            REQUIRE(n_tabs(workspace) == 3);
            CHECK(workspace.session.file_name() == "gerber_beam.json");
            CHECK(tab(workspace, 0).model().title == "Changed");
            return context.pixels();
        },
        golden::this_machine());
}

TEST_CASE("A copy for another window is what the file would hold, not what it holds, with what is shown and how")
{
    const ui::Fonts fonts;
    golden::if_drawn(
        [&] {
            ui::Offscreen context({.size = {320, 200}});
            Application application(context, fonts, opened("examples/portal.json"));
            Session& session = application.workspace().session;
            session.change({ui::translatable("Change"), [](Document& document) { set_title(document, "Changed"); }});
            session.view.show = ShowSet{Show::N, Show::Loads};
            session.view.load_case = femoop::CaseId(1);
            const ui::ExportToApp copy = application.copy_of_document();
            CHECK(copy.document == femoop::write_model(session.model()));
            CHECK(copy.document.find("Changed") != std::string::npos);
            CHECK(copy.options == std::vector<std::string>{"--lang", "en", "--theme", "light", "--show", "loads,N",
                                                           "--case", session.model().case_name(femoop::CaseId(1))});
            session.view.is_envelope = true; // which no option asks for
            CHECK(application.copy_of_document().options.size() == 6);
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
    const auto before = locked_scale(session.model(), *session.solution().results, femoop::CaseId(0));
    load(Step::Drag, -13.0);
    REQUIRE(session.draw_state.locked_scale);
    load(Step::Drag, -20.0);
    CHECK(session.draw_state.locked_scale->largest == before->largest);
    session.settle();
    CHECK(!session.draw_state.locked_scale);
}

TEST_SUITE_END();
