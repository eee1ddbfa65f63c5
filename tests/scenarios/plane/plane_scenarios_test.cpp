// Every scenario of this folder, played in the real window of the plane app off screen: what it expects is found, and
// what it keeps looks as it did.
#include "apps/plane/window/run.h"
#include "apps/plane/window/stage.h"
#include "tests/golden/scene.h"
#include "tests/scenarios/played.h"
#include "tests/scenarios/random_hand.h"
#include "tests/scenarios/script_files.h"
#include "ui/context/offscreen.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

namespace fs = std::filesystem;
using namespace plane;

namespace {

/// What went wrong, "" for nothing.
std::string played(const std::string& script, ui::PixelSize size = {1280, 800})
{
    return played_in<Application, OffscreenStage>(script, Session(), size);
}

} // namespace

TEST_CASE("The steps on the page of the plane app can be played")
{
    const std::string script = scenario_on(text_of(repository() / "courseware/reference/plane-app.md"));
    CHECK(script.starts_with("# "));
    CHECK(played(script) == "");
}

TEST_CASE("What goes wrong in a scenario of the plane app is told with its line")
{
    CHECK(played("click point Q") == "line 1: found \"point Q\", wanted a point of the drawing");
    CHECK(played("expect faces 3") == "line 1: faces: found 0, wanted 3");
    CHECK(played("command edit.undo") == "line 1: nothing was changed yet");
    CHECK(played("command part.set x 3") == "line 1: nothing is selected");
    CHECK(played("expect luck").starts_with("line 1: expect: found \"luck\", wanted one of drawn"));
}

TEST_CASE("A drawing is described without a screen and a broken file is told")
{
    const Folder folder;
    ui::AppOptions options;
    options.describe = true;
    CHECK(run(options) == 0);
    options.files = {(repository() / "examples/plate.json").string()};
    CHECK(run(options) == 0);
    options.files = {folder.write("broken.json", "{\"cremona\": 1, \"analysis\": \"plane_stress\"")};
    CHECK(run(options) == 2);
    options.files = {folder.path("missing.json")};
    CHECK(run(options) == 2);
    options.files = {"/dev/zero"}; // it has no end
    CHECK(run(options) == 2);
}

TEST_CASE("Random hands spoil no picture of a plate")
{
    let_random_hands_work<Application, OffscreenStage>(
        Session(), {"examples/plate.json", "examples/dam.json", "examples/cantilever_plate.json"});
}

TEST_CASE("Every scenario of the plane app begins with its claim and is played to its end")
{
    for (const fs::path& file : scenarios_in("tests/scenarios/plane")) {
        SUBCASE(file.stem().c_str())
        {
            CAPTURE(file.string());
            const std::string script = text_of(file);
            CHECK(script.starts_with("# "));
            CHECK(played(script) == "");
        }
    }
}
