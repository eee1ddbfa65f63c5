// Every scenario of this folder, played in the stepper's real window off screen: what it expects is found, and what it
// keeps looks as it did.
#include "apps/euler/window/run.h"
#include "apps/euler/window/stage.h"
#include "tests/scenarios/played.h"
#include "tests/scenarios/random_hand.h"
#include "tests/scenarios/script_files.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

namespace fs = std::filesystem;
using namespace euler;

namespace {

/// What went wrong, "" for nothing.
std::string played(const std::string& script) { return played_in<Application, OffscreenStage>(script, Session()); }

} // namespace

TEST_CASE("Random hands spoil no picture of a solid")
{
    let_random_hands_work<Application, OffscreenStage>(
        Session(), {"examples/cube.eul", "examples/hoffmann.eul", "examples/shell_and_hole.eul"});
}

TEST_CASE("The steps on the stepper's reference page can be played")
{
    const std::string script = scenario_on(text_of(repository() / "courseware/reference/euler-app.md"));
    CHECK(script.starts_with("# "));
    CHECK(played(script) == "");
}

TEST_CASE("In a small window the class reads the whole formula")
{
    const std::string script = "command file.open examples/torus_by_rotation.eul\ncommand view.language.pt\nkey F5\n"
                               "wait 0.5\npicture euler_projector_small\n";
    CHECK(played_in<Application, OffscreenStage>(script, Session(), {900, 600}) == "");
}

TEST_CASE("What goes wrong in a stepper's scenario is told with its line, what was found and what was wanted")
{
    const std::string open = "command file.open examples/cube.eul\n";
    CHECK(played(open + "click vertex v99") ==
          "line 2: found \"vertex v99\", wanted a place: "
          "vertex v1, edge v1 v2, half-edge v1 v2, face f1, (2, 0) or pixel 400 300");
    CHECK(played(open + "expect counts 8 12 6 6 1 1") == "line 2: counts: found 8 12 6 6 1 0, wanted 8 12 6 6 1 1");
    CHECK(played(open + "command step.forward") == "line 2: this is the last step");
    CHECK(played(open + "command step.go_to 14") == "line 2: step.go_to: found \"14\", wanted a step from 0 to 13");
    CHECK(played(open + "command step.apply mef s1 f1 v1 v2 f9").starts_with("line 2: "));
    CHECK(played(open + "command edit.jump") ==
          "line 2: found command \"edit.jump\", wanted one of the app's; the palette (Ctrl+K) lists them");
    CHECK(played(open + "expect luck").starts_with("line 2: expect: found \"luck\", wanted one of drawn"));
}

TEST_CASE("A screenshot, a description and a scenario need no screen, and a broken script is told")
{
    const Folder folder;
    Options options;
    options.files = {repository() / "examples/cube.eul"};
    options.describe = true;
    CHECK(run(options) == 0);
    options.files = {folder.write("broken.eul", "mvfs s1 f1 v1 0 0 0\nmev s1 f1 v9 v2 1 0 0\n")};
    CHECK(run(options) == 2);
    options.files = {folder.path("missing.eul")};
    CHECK(run(options) == 2);
    options.files = {"/dev/zero"}; // it has no end
    CHECK(run(options) == 2);
}

TEST_CASE("Comments and names of any length are drawn")
{
    const Folder folder;
    std::string comments;
    for (int i = 0; i < 6000; ++i) comments += "# ab cd ef gh\n";
    const std::string name = "v" + std::string(60'000, 'x');
    const fs::path file = folder.write("long.eul", comments + "mvfs s1 f1 " + name + " 0 0 0\n");
    CHECK(played("command file.open " + file.string() + "\nclick vertex " + name + "\nwait 0.1\n") == "");
}

TEST_CASE("Every scenario of the stepper begins with its claim and is played to its end")
{
    for (const fs::path& file : scenarios_in("tests/scenarios/euler")) {
        SUBCASE(file.stem().c_str())
        {
            CAPTURE(file.string());
            const std::string script = text_of(file);
            CHECK(script.starts_with("# "));
            CHECK(played(script) == "");
        }
    }
}
