// What comes in between: files dropped while something is made, dialogs that were given up.
#include "apps/frame/session/tabs.h"
#include "apps/frame/window/stage.h"
#include "tests/apps/frame_window/opened.h"
#include "tests/folder.h"
#include "tests/golden/scene.h"
#include "tests/source_folder.h"

#include <doctest/doctest.h>

#include <functional>
#include <string>

using namespace frame;

namespace {

const std::string folder = source_folder() + "/";

void with_application(const std::function<void(ui::Offscreen&, Application&)>& act)
{
    const ui::Fonts fonts;
    golden::if_drawn(
        [&] {
            ui::Offscreen context({.size = {640, 400}});
            Application application(context, fonts, opened("examples/portal.json"));
            act(context, application);
            return context.pixels();
        },
        golden::this_machine());
}

} // namespace

TEST_SUITE("frame window: interruptions")
{
    TEST_CASE("A file that is dropped while a typical structure is chosen waits until that is done")
    {
        with_application([](ui::Offscreen&, Application& application) {
            Workspace& workspace = application.workspace();
            workspace.typical.open(workspace.session);
            application.frame({.dropped_files = {folder + "examples/truss.json"}});
            CHECK(n_tabs(workspace) == 1);
            CHECK(workspace.session.notice);
            workspace.typical.cancel(workspace.session);
            application.frame({.dropped_files = {folder + "examples/truss.json"}});
            CHECK(n_tabs(workspace) == 2);
        });
    }

    TEST_CASE("An export that was given up leaves nothing to the next dialog: a file is opened, not written")
    {
        with_application([](ui::Offscreen& context, Application& application) {
            const std::string script = "command file.export\nwait 0.1\nkey Esc\nwait 0.1\ncommand file.open\nwait 0.1\n"
                                       "type \"" +
                                       folder +
                                       "examples/truss.json\"\nkey Enter\nwait 0.1\n"
                                       "expect notice nothing\nexpect file truss.json\n";
            OffscreenStage stage(application, context, [](auto, const auto&) {});
            CHECK_NOTHROW(ui::play(script, context, application, stage, {}));
        });
    }

    TEST_CASE("Results that are hidden from a class are not written as CSV either, and the reason is told")
    {
        with_application([](ui::Offscreen&, Application& application) {
            const Folder files;
            CHECK(!application.export_as(files.path() / "all.csv"));
            REQUIRE(!ui::run(*application.commands().find("view.hide_results"), application.workspace()));
            const auto reason = application.export_as(files.path() / "hidden.csv");
            REQUIRE(reason);
            CHECK(ui::Catalogue()(*reason) == "The results are hidden; H reveals them.");
            CHECK(!files.has("hidden.csv"));
        });
    }
}
