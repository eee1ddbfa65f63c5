// Every scenario of this folder, played in the real window of moment distribution off screen: what it expects is found,
// and what it keeps looks as it did.
#include "apps/cross/window/run.h"
#include "apps/cross/window/stage.h"
#include "tests/scenarios/played.h"
#include "tests/scenarios/random_hand.h"
#include "tests/scenarios/script_files.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>

namespace fs = std::filesystem;
using namespace cross;

namespace {

/// What went wrong, "" for nothing.
std::string played(const std::string& script) { return played_in<Application, OffscreenStage>(script, Session()); }

} // namespace

TEST_CASE("Random hands spoil no picture of moment distribution")
{
    let_random_hands_work<Application, OffscreenStage>(
        Session(), {"examples/portal.json", "examples/continuous_beam.json", "examples/storey_frame.json"});
}

TEST_CASE("The steps on the page of moment distribution can be played")
{
    const std::string script = scenario_on(text_of(repository() / "courseware/reference/cross-app.md"));
    CHECK(script.starts_with("# "));
    CHECK(played(script) == "");
}

TEST_CASE("What goes wrong in a scenario of moment distribution is told with its line")
{
    CHECK(played("click joint X") == "line 1: found \"joint X\", wanted a joint that can be balanced");
    CHECK(played("click joint A") == "line 1: found \"joint A\", wanted a joint that can be balanced"); // it is pinned
    CHECK(played("expect step 1") == "line 1: step: found 0, wanted 1");
    CHECK(played("expect total BA 64") == "line 1: total: found BA -64, wanted BA 64");
    CHECK(played("expect total XY 64") == "line 1: expect: found \"XY\", wanted a member end of the sheet");
    CHECK(played("command edit.undo") == "line 1: nothing was changed yet");
    CHECK(played("command work.back") == "line 1: every joint is locked: this is the start");
    CHECK(played("command work.branch") == "line 1: there is one way only; go back and click another joint");
    CHECK(played("command file.open examples/portal.json\ncommand edit.left_end") ==
          "line 2: no span ends alone at this side");
    CHECK(played("command work.next_sheet") == "line 1: the structure cannot sway: it has one sheet");
    CHECK(played("command work.balance D") == "line 1: work.balance: found \"D\", wanted a joint that can be balanced");
    CHECK(played("command method.digits x") == "line 1: method.digits: found \"x\", wanted a number");
    CHECK(played("command method.case W") == "line 1: method.case: found \"W\", wanted a load case or combination");
    CHECK(played("expect luck").starts_with("line 1: expect: found \"luck\", wanted one of drawn"));
}

TEST_CASE("A sheet is described without a screen and a broken file is told")
{
    const Folder folder;
    ui::AppOptions options;
    options.describe = true;
    CHECK(run(options) == 0);
    options.files = {folder.write("broken.json", "{\"cremona\": 1, \"nodes\": 3}")};
    CHECK(run(options) == 2);
    options.files = {folder.path("missing.json")};
    CHECK(run(options) == 2);
    options.files = {"/dev/zero"}; // it has no end
    CHECK(run(options) == 2);
}

TEST_CASE("What cannot be distributed is refused in words on stderr: a truss with status 2, a mechanism with 3")
{
    ui::AppOptions options;
    options.describe = true;
    const auto described = [&](const std::string& file) {
        options.files = {file};
        std::ostringstream out, err;
        auto* const cout = std::cout.rdbuf(out.rdbuf());
        auto* const cerr = std::cerr.rdbuf(err.rdbuf());
        const int status = run(options);
        std::cout.rdbuf(cout);
        std::cerr.rdbuf(cerr);
        CHECK(out.str().empty());
        CHECK(!err.str().empty());
        return status;
    };
    CHECK(described((repository() / "examples/truss.json").string()) == 2);
    CHECK(described((repository() / "examples/mechanism.json").string()) == 3);
}

TEST_CASE("Every scenario of moment distribution begins with its claim and is played to its end")
{
    for (const fs::path& file : scenarios_in("tests/scenarios/cross")) {
        SUBCASE(file.stem().c_str())
        {
            CAPTURE(file.string());
            const std::string script = text_of(file);
            CHECK(script.starts_with("# "));
            CHECK(played(script) == "");
        }
    }
}
