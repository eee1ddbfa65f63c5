#include "tests/apps/cli/shown_commands.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "tests/apps/cli/run_cremona.h"
#include "tests/source_folder.h"

namespace cli_test {

namespace {

/// A command line, and lines of which each stands in what it prints.
struct Shown {
    std::string command;
    std::vector<std::string> lines;
};

// A block may stand indented, within a list.
std::vector<Shown> shown_commands(const std::string& page)
{
    std::vector<Shown> all;
    bool is_inside = false;
    std::size_t indent = 0;
    std::istringstream text(page);
    for (std::string line; std::getline(text, line);) {
        const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
        if (line.compare(begin, 3, "```") == 0) {
            is_inside = line.substr(begin) == "```console";
            indent = begin;
            continue;
        }
        if (!is_inside) continue;
        line.erase(0, std::min(indent, begin));
        if (line.starts_with("$ ")) all.push_back({line.substr(2), {}});
        else all.back().lines.push_back(line);
    }
    return all;
}

} // namespace

std::size_t run_shown_commands(const std::string& page, const Folder& folder)
{
    for (const std::string part : {"examples", "tests"})
        std::filesystem::create_directory_symlink(source_folder() + "/" + part, folder.path(part));
    const std::vector<Shown> all = shown_commands(page);
    for (const Shown& shown : all) {
        CAPTURE(shown.command);
        const Run run = shell("cd '" + folder.path("") + "' && " + shown.command);
        CHECK_MESSAGE(run.status == 0, run.err);
        for (const std::string& line : shown.lines) {
            CAPTURE(line);
            CHECK_MESSAGE((has(run.out, line) || has(run.err, line)), run.out << run.err);
        }
    }
    return all.size();
}

} // namespace cli_test
