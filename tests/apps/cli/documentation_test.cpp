// The reference page of the command line: its examples run and print what it says, and it leaves no option out.
#include <doctest/doctest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/apps/cli/run_cremona.h"
#include "tests/apps/cli/shown_commands.h"
#include "tests/text_of.h"

using cli_test::has;
using cli_test::Run;

TEST_SUITE_BEGIN("cremona");

namespace {

std::string page() { return text_of_source("courseware/reference/command-line.md"); }

} // namespace

TEST_CASE("Every command on the page of the command line runs, and prints what the page shows")
{
    const Folder folder;
    CHECK(cli_test::run_shown_commands(page(), folder) > 15);
    for (const char* file :
         {"portal.svg", "moments.png", "sag.pdf", "motion.svg", "portal.pdf", "portal.csv", "results", "front.png"})
        CHECK_MESSAGE(folder.has(file), file);
}

TEST_CASE("Every option of every command stands on the page")
{
    const std::string text = page();
    for (const char* command : {"solve", "verify", "check", "render", "convert", "cross", "influence", "train", "truss",
                                "euler", "mohr", "bench"}) {
        std::istringstream help(cli_test::cremona({command, "--help"}).out);
        for (std::string word; help >> word;) {
            if (!word.starts_with("--") || word.size() < 4) continue;
            word = word.substr(0, word.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"));
            CAPTURE(command);
            CHECK_MESSAGE(has(text, word), word);
        }
    }
}

TEST_SUITE_END();
