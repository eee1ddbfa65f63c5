// Every scenario of this folder, played in the real window of Mohr's circle off screen: what it expects is found, and
// what it keeps looks as it did.
#include "apps/mohr/window/run.h"
#include "apps/mohr/window/stage.h"
#include "tests/golden/scene.h"
#include "tests/scenarios/played.h"
#include "tests/scenarios/script_files.h"
#include "ui/context/offscreen.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace fs = std::filesystem;
using namespace mohr;

namespace {

/// What went wrong, "" for nothing.
std::string played(const std::string& script) { return played_in<Application, OffscreenStage>(script, Session()); }

} // namespace

TEST_CASE("The steps on the page of Mohr's circle can be played")
{
    const std::string script = scenario_on(text_of(repository() / "courseware/reference/mohr-app.md"));
    CHECK(script.starts_with("# "));
    CHECK(played(script) == "");
}

TEST_CASE("What goes wrong in a scenario of Mohr's circle is told with its line")
{
    CHECK(played("click face z").starts_with("line 1: found \"face z\", wanted a place: face x, face y, plane, "));
    CHECK(played("click normal") == "line 1: found \"normal\", wanted one that is drawn");
    CHECK(played("expect principal 70 30") == "line 1: principal: found 70 -30, wanted 70 30");
    CHECK(played("command edit.undo") == "line 1: nothing was changed yet");
    CHECK(played("command state.set 4 12 MPa") ==
          "line 1: state.set: found \"4 12 MPa\", wanted a place from 1 to 3 and a number");
    CHECK(played("command state.set 1 12 kN").starts_with("line 1: "));
    CHECK(played("command plane.turn x") == "line 1: plane.turn: found \"x\", wanted an angle in degrees");
    CHECK(played("expect luck").starts_with("line 1: expect: found \"luck\", wanted one of drawn"));
}

TEST_CASE("A state is described without a screen and a broken file is told")
{
    const Folder folder;
    ui::AppOptions options;
    options.describe = true;
    CHECK(run(options) == 0);
    options.files = {folder.write("broken.mohr", "{\"cremona\": 1, \"mohr\": \"plane\"}")};
    CHECK(run(options) == 2);
    options.files = {folder.path("missing.mohr")};
    CHECK(run(options) == 2);
    options.files = {"/dev/zero"}; // it has no end
    CHECK(run(options) == 2);
}

TEST_CASE("The projector makes no circle smaller, nor one that is being constructed")
{
    const Workplace workplace;
    for (const ui::PixelSize size : {ui::PixelSize{1280, 800}, {1920, 1080}, {1024, 768}})
        golden::if_drawn([&] {
            const ui::Fonts fonts;
            ui::Offscreen context({.size = size});
            for (const SubjectEntry& subject : subjects())
                for (const char* const steps : {"construction.whole", "construction.last"}) {
                    Application application(context, fonts, Session());
                    const auto do_all = [&](std::initializer_list<std::string_view> ids) {
                        for (const std::string_view id : ids)
                            run(*application.commands().find(id), application.workspace());
                        application.frame({});
                        application.frame({});
                        return application.canvas().drawn().circle.scale();
                    };
                    CAPTURE(size.width);
                    CAPTURE(subject.id);
                    CAPTURE(steps);
                    const double before = do_all({subject.id, steps});
                    CHECK(do_all({"view.project"}) >= before);
                }
            return context.pixels();
        });
}

TEST_CASE("Every scenario of Mohr's circle begins with its claim and is played to its end")
{
    for (const fs::path& file : scenarios_in("tests/scenarios/mohr")) {
        SUBCASE(file.stem().c_str())
        {
            CAPTURE(file.string());
            const std::string script = text_of(file);
            CHECK(script.starts_with("# "));
            CHECK(played(script) == "");
        }
    }
}
