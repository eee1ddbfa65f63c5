// The lesson on Euler operators: what it shows runs, comes to the counts that it tells, and fails where it says so.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/text_of.h"
#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/script/script_runner.h"
#include "topology/tables/table_text.h"
#include "topology/text/line_error.h"

using namespace topology;

namespace {

std::string lesson_page() { return text_of_source("courseware/01-euler-operators.md"); }

/// What stands between the fences of a kind, in the order of the page.
std::vector<std::string> blocks(const std::string& text, const std::string& kind)
{
    const std::string opening = "```" + kind + "\n", closing = "```";
    std::vector<std::string> found;
    for (std::size_t begin = text.find(opening); begin != std::string::npos; begin = text.find(opening, begin)) {
        begin += opening.size();
        found.push_back(text.substr(begin, text.find(closing, begin) - begin));
    }
    return found;
}

/// As the last line of a script tells them.
std::string counts_line(const Solid& solid)
{
    const EulerCounts n = euler_counts(solid);
    const auto s = [](std::size_t count) { return std::to_string(count); };
    return "# V " + s(n.V) + ", E " + s(n.E) + ", F " + s(n.F) + ", L " + s(n.L) + ", S " + s(n.S) + ", G " + s(n.G);
}

} // namespace

TEST_SUITE("lesson on Euler operators")
{
    TEST_CASE("Every script of the lesson leaves a sound solid with the counts that its last line tells")
    {
        const std::vector<std::string> scripts = blocks(lesson_page(), "eul");
        REQUIRE(scripts.size() == 4);
        for (const std::string& script : scripts) {
            CAPTURE(script);
            ScriptRunner runner;
            REQUIRE_NOTHROW(run_script(runner, script, {}));
            const Solid& solid = runner.solids().front().solid;
            CHECK_NOTHROW(validate(solid));
            CHECK(script.ends_with(counts_line(solid) + "\n"));
        }
    }

    TEST_CASE("The tables that the lesson reads are those after MVFS and MEV")
    {
        ScriptRunner runner;
        run_script(runner, "mvfs s1 f1 v1 0 0 0\nmev s1 f1 v1 v2 0 1 0\n", {});
        CHECK(blocks(lesson_page(), "text").front() == table_text(runner.solids().front().solid));
    }

    TEST_CASE("The experiment that fails on purpose gives the message that the lesson explains")
    {
        const std::string text = lesson_page();
        REQUIRE(blocks(text, "fails").size() == 1);
        ScriptRunner runner;
        std::string message;
        try {
            run_script(runner, blocks(text, "fails").front(), {});
        } catch (const LineError& fault) {
            message = fault.what();
        }
        CHECK(blocks(text, "text").back().find(message + "\n") != std::string::npos);
        CHECK(message.starts_with("line 4: "));
    }
}
