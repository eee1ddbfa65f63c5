#include <doctest/doctest.h>

#include <string>

#include "apps/frame/session/commands.h"
#include "tests/text_of.h"

namespace {

std::string page() { return text_of_source("courseware/reference/frame-app.md"); }

/// The line of a command in the page's table of keys.
std::string line(const frame::CommandTable::Entry& command)
{
    std::string keys;
    for (const ui::Chord chord : command.shortcuts) keys += (keys.empty() ? "`" : ", `") + text(chord) + "`";
    return "| " + keys + " | " + std::string(command.label) + " |\n";
}

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE("The reference page of the frame app lists every key with what it does")
    {
        const std::string text = page();
        REQUIRE(!text.empty());
        std::string missing;
        const frame::CommandTable table = frame::command_table();
        for (const auto& command : table.all()) {
            if (command.shortcuts.empty() || text.find(line(command)) != std::string::npos) continue;
            missing += line(command);
        }
        CHECK(missing == "");
    }
}
