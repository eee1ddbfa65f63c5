// Which words open an app, and which app a file is opened in.
#include <doctest/doctest.h>

#include "apps/cli/open_app.h"
#include "tests/apps/cli/run_cremona.h"
#include "tests/source_folder.h"

using cli::app_of_file;
using cli::asked_app;
using cli_test::has;

TEST_SUITE_BEGIN("cremona");

namespace {

std::string example(const std::string& name) { return source_folder() + "/examples/" + name; }

} // namespace

TEST_CASE("A file is opened in the app of what it holds")
{
    CHECK(app_of_file(example("portal.json")) == "frame");
    CHECK(app_of_file(example("truss.json")) == "frame");
    CHECK(app_of_file(example("plate.json")) == "plane");
    CHECK(app_of_file(example("three_spans.json")) == "cross"); // it holds a sheet
    CHECK(app_of_file(example("cube.eul")) == "euler");
    const Folder folder;
    folder.write("state.mohr", "{}");
    CHECK(app_of_file(folder.path("state.mohr")) == "mohr");
    folder.write("faulty.json", "{");
    CHECK(app_of_file(folder.path("faulty.json")) == "frame"); // which says what is wrong
}

TEST_CASE("The name of an app opens it, and a name that is a command too does so without more words alone")
{
    CHECK(asked_app({"frame", "a.json", "--theme", "dark"})->arguments.size() == 3);
    CHECK(asked_app({"plane"})->program == "plane");
    for (const char* name : {"cross", "mohr", "euler"}) {
        CAPTURE(name);
        CHECK(asked_app({name})->program == name);
        CHECK(!asked_app({name, "--help"}));
    }
}

TEST_CASE(
    "A word that is a file opens it with all that follows; one that is a command, an option or nothing opens no app")
{
    const std::string file = example("hole.json");
    const auto app = asked_app({file, "--lang", "pt"});
    REQUIRE(app);
    CHECK(app->program == "plane");
    CHECK(app->arguments.front() == file);
    CHECK(!asked_app({}));
    CHECK(!asked_app({"solve", file}));
    CHECK(!asked_app({"--version"}));
    CHECK(!asked_app({"no_such_file.json"}));
}

TEST_CASE("The program becomes the app that is beside it")
{
    const cli_test::Run run = cli_test::cremona({example("portal.json"), "--describe", "--lang", "en"});
    CHECK(run.status == 0);
    CHECK(has(run.out, "A plane frame"));
}

TEST_SUITE_END();
