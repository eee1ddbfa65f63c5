// The reference page of the command line: its examples run and print what it says, and it leaves no option out.
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/apps/cli/run_cremona.h"

using cli_test::has;
using cli_test::Run;

TEST_SUITE_BEGIN("cremona");

namespace {

std::string page()
{
    std::ifstream file(std::string(CREMONA_SOURCE_DIR) + "/courseware/reference/command-line.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A command line of a ```console block, and lines of which each stands in what it prints.
struct Shown {
    std::string command;
    std::vector<std::string> lines;
};

std::vector<Shown> shown_commands()
{
    std::vector<Shown> all;
    bool is_inside = false;
    std::istringstream text(page());
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("```")) is_inside = line == "```console";
        else if (is_inside && line.starts_with("$ ")) all.push_back({line.substr(2), {}});
        else if (is_inside) all.back().lines.push_back(line);
    }
    return all;
}

} // namespace

TEST_CASE("Every command on the page of the command line runs, and prints what the page shows")
{
    const Folder folder;
    for (const std::string part : {"examples", "tests"})
        std::filesystem::create_directory_symlink(std::string(CREMONA_SOURCE_DIR) + "/" + part, folder.path(part));
    const std::vector<Shown> all = shown_commands();
    REQUIRE(all.size() > 15);
    for (const Shown& shown : all) {
        CAPTURE(shown.command);
        const Run run = cli_test::shell("cd '" + folder.path("") + "' && " + shown.command);
        CHECK_MESSAGE(run.status == 0, run.err);
        for (const std::string& line : shown.lines) {
            CAPTURE(line);
            CHECK_MESSAGE((has(run.out, line) || has(run.err, line)), run.out << run.err);
        }
    }
    for (const char* file :
         {"portal.svg", "moments.png", "sag.pdf", "motion.svg", "portal.pdf", "portal.csv", "results",
          "front.png"})
        CHECK_MESSAGE(folder.has(file), file);
}

TEST_CASE("Every option of every command stands on the page")
{
    const std::string text = page();
    for (const char* command : {"solve", "verify", "check", "render", "convert", "cross", "euler", "mohr", "bench"}) {
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
