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
std::string played(const std::string& script, ui::PixelSize size = {1280, 800})
{
    return played_in<Application, OffscreenStage>(script, Session(), size);
}

/// How many pixels have the colour that frames what the keyboard has.
int n_framed(const ui::Pixels& pixels)
{
    const ui::Color frame = ui::Theme(ui::ThemeName::Light)[ui::Role::Selection].stroke.color;
    int n = 0;
    for (int y = 0; y < pixels.size.height; ++y)
        for (int x = 0; x < pixels.size.width; ++x) {
            const auto* const p = pixels.at(x, y);
            if (p[0] == frame.r && p[1] == frame.g && p[2] == frame.b) ++n;
        }
    return n;
}

} // namespace

TEST_CASE("What rests is drawn alike in every frame, in every state and both languages")
{
    const Workplace workplace;
    for (const ui::Language language : ui::all_languages)
        golden::if_drawn([&] {
            const ui::Fonts fonts;
            ui::Offscreen context({.size = {1280, 800}});
            Application application(context, fonts, Session());
            application.workspace().set_language(language);
            for (const SubjectEntry& subject : subjects()) {
                CAPTURE(subject.id);
                run(*application.commands().find(subject.id), application.workspace());
                for (int i = 0; i < 10; ++i) application.frame({});
                const ui::Pixels before = context.pixels();
                for (int i = 0; i < 5; ++i) {
                    application.frame({});
                    CHECK((context.pixels() == before));
                }
            }
            return context.pixels();
        });
}

TEST_CASE("Nothing is framed in blue once the dialog of an export is closed, by a file or by Escape")
{
    for (const ui::Key key : {ui::Key::Enter, ui::Key::Escape}) {
        const Workplace workplace;
        golden::if_drawn([&] {
            const ui::Fonts fonts;
            ui::Offscreen context({.size = {1280, 800}});
            Application application(context, fonts, Session());
            application.workspace().set_panels_visible(false);
            const auto rest = [&] {
                for (int i = 0; i < 5; ++i) application.frame({});
            };
            rest();
            const int before = n_framed(context.pixels());
            const ui::Point at = application.canvas().corner() + ui::Point{30.0, 300.0};
            application.frame({.pointer = at});
            application.frame({.pointer = at, .is_button_down = {true}});
            application.frame({.pointer = at});
            run(*application.commands().find("file.export"), application.workspace());
            rest();
            application.frame({.text = "mine"});
            rest();
            application.frame({.keys = {{key, true}}});
            application.frame({.keys = {{key, false}}});
            rest();
            CHECK(n_framed(context.pixels()) == before);
            return context.pixels();
        });
    }
}

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

TEST_CASE("In a small window on the projector neither the curves nor a criterion's locus are squeezed")
{
    // The names of what has no room are left out.
    const auto shows = [](const std::string& script, const std::string& name) {
        return played(script + "command view.project\nwait 0.1\nexpect drawn \"" + name + "\"", {900, 600});
    };
    const std::string both = "command view.show.both_rules\n", tresca = "command criterion.tresca\n";
    CHECK(shows("command criterion.mohr_coulomb\n", "σ2") == "");
    CHECK(shows("key 4\n" + tresca, "σ2") == "");
    CHECK(shows(both + tresca, "σ2") == "");
    CHECK(shows(both, "σ = 68.69") == "");
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
