// Every scenario of this folder, played in the real window off screen: what it expects is found, and what it keeps
// looks as it did.
#include "apps/frame/window/run.h"
#include "apps/frame/window/stage.h"
#include "tests/folder.h"
#include "tests/scenarios/played.h"
#include "tests/scenarios/random_hand.h"
#include "tests/scenarios/script_files.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

namespace fs = std::filesystem;
using namespace frame;

namespace {

Session as_a_person_begins()
{
    Session session(starting_document());
    session.view.layout = Layout::Overlay;
    session.view.show = shown_by_default | ShowSet{Show::M};
    return session;
}

/// What went wrong, "" for nothing.
std::string played(const std::string& script, ui::PixelSize size = {1280, 800})
{
    return played_in<Application, OffscreenStage>(script, as_a_person_begins(), size);
}

} // namespace

TEST_CASE("Random hands spoil no picture of a structure")
{
    let_random_hands_work<Application, OffscreenStage>(
        as_a_person_begins(), {"examples/portal.json", "examples/influence.json", "examples/pratt_truss.json",
                               "examples/grillage.json", "examples/mechanism.json", "examples/bridge.json"});
}

TEST_CASE("The steps on the reference page of scenarios can be played")
{
    const std::string script = scenario_on(text_of(repository() / "courseware/reference/scenarios.md"));
    CHECK(script.starts_with("# "));
    CHECK(played(script) == "");
}

TEST_CASE("What goes wrong in a scenario is told with its line, what was found and what was wanted")
{
    const std::string open = "command file.open examples/portal.json\n";
    CHECK(played(open + "click node K") == "line 2: found \"node K\", wanted a node of the model: A, B, C, D");
    CHECK(played(open + "click member XY 50%") ==
          "line 2: found \"member XY 50%\", wanted a place along a member of the model: AB, BC, CD");
    CHECK(played(open + "hover beam") ==
          "line 2: found \"beam\", wanted a place: node B, member AB 50%, member AB 2.5, (2, 0) or pixel 400 300");
    CHECK(played(open + "expect value member BC M at 50% is 60 kN·m") == "line 2: M: found 58.52 kN·m, wanted 60 kN·m");
    CHECK(played(open + "expect value member BC Q at 50% is 0 kN") ==
          "line 2: value: found \"Q\", wanted one of x, N, V, M, u, v");
    CHECK(played(open + "expect node C at (8, 6)") == "line 2: node C: found at (8, 4.5), wanted (8, 6)");
    CHECK(played(open + "expect undo Draw a member") == "line 2: undo: found nothing, wanted Draw a member");
    CHECK(played(open + "command edit.jump") ==
          "line 2: found command \"edit.jump\", wanted one of the app's; the palette (Ctrl+K) lists them");
    CHECK(played(open + "expect luck").starts_with("line 2: expect: found \"luck\", wanted one of drawn, not drawn"));
}

TEST_CASE("In a small window the value of the load that is put is in sight and is typed")
{
    CHECK(played("command file.open examples/portal.json\nkey L\nclick pixel 600 39\nkey Ctrl+A\ntype \"7.5 kN/m\"\n"
                 "key Enter\nclick member CD 50%\nexpect undo Load: Member CD\nexpect drawn \"7.5 kN/m\"\n",
                 {900, 600}) == "");
}

TEST_CASE("In a small window the tab of every document is reached, though there are many")
{
    std::string open;
    for (const char* name : {"portal", "truss", "gerber_beam", "storey_frame", "balcony", "bridge", "grillage",
                             "three_spans", "mechanism"})
        open += std::string("command file.open examples/") + name + ".json\n";
    CHECK(played(open + "wait 0.1\nclick pixel 450 67\nexpect file three_spans.json\n"
                        "wheel pixel 450 67 40\nwait 0.1\nclick pixel 260 67\nexpect file portal.json\n"
                        "key Ctrl+Shift+Tab\nwait 0.1\nclick pixel 450 67\nexpect file three_spans.json\n",
                 {900, 600}) == "");
}

TEST_CASE("In a small window on the projector the words on an empty sheet go on in the next line")
{
    CHECK(played("command view.language.pt\ncommand view.theme.projector\ncommand file.new\nkey 2\nwait 0.1\n"
                 "expect not drawn \"M desenha barras, N nós, S apoios, L cargas.\"\nexpect drawn \"comando.\"\n",
                 {600, 500}) == "");
}

TEST_CASE("In a wide window on the projector the structure has the room over a table, and the legend steps aside")
{
    CHECK(
        played(
            "command file.open examples/portal.json\nkey F5\nwait 0.2\nexpect drawn \"Portal frame with fixed bases\"\n"
            "key F4\nwait 0.2\nexpect not drawn \"Portal frame with fixed bases\"\nexpect drawn \"58.52\"\n",
            {1600, 950}) == "");
}

TEST_CASE("On the projector both diagrams of virtual work on a beam have room over their table")
{
    CHECK(played("command view.theme.projector\ncommand file.open examples/continuous_beam.json\nwait 0.1\n"
                 "key Shift+P\nclick member AB 40%\nwait 0.2\nexpect drawn \"Under the loads: F\"\n"
                 "expect drawn \"Under the unit load: f\"\nexpect drawn \"1.225\"\nexpect drawn \"25 kN/m\"\n"
                 "picture window_virtual_work_beam_projector\n",
                 {1280, 775}) == "");
}

TEST_CASE("Every frame of a scenario can be kept for a film")
{
    const Folder folder;
    golden::if_drawn(
        [&] {
            Options options;
            options.play = folder.write("film.scenario", "wait 0.05\npicture end\n");
            options.frames = folder.path("film");
            options.pictures = folder.path("pictures");
            options.settings.window = {320.0, 240.0};
            CHECK(run(options) == 0);
            for (const char* frame : {"film/frame_00001.png", "film/frame_00003.png", "pictures/end.png"})
                CHECK(ui::read_png(folder.path(frame)).size == ui::PixelSize{320, 240});
            CHECK(!folder.has("film/frame_00004.png"));
            return ui::Pixels{};
        },
        golden::this_machine());
}

TEST_CASE("Every scenario begins with its claim and is played to its end")
{
    for (const fs::path& file : scenarios_in("tests/scenarios")) {
        SUBCASE(file.stem().c_str())
        {
            CAPTURE(file.string());
            const std::string script = text_of(file);
            CHECK(script.starts_with("# "));
            CHECK(played(script) == "");
        }
    }
}
