// The reference page of the scripts: what it shows runs, and it leaves no operator out.
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/script/script_runner.h"
#include "topology/text/line_error.h"

using namespace topology;

namespace {

std::string page()
{
    std::ifstream file(CREMONA_SOURCE_DIR "/courseware/reference/euler-scripts.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> scripts_of(const std::string& text)
{
    const std::string opening = "```eul\n", closing = "```";
    std::vector<std::string> scripts;
    for (std::size_t begin = text.find(opening); begin != std::string::npos; begin = text.find(opening, begin)) {
        begin += opening.size();
        scripts.push_back(text.substr(begin, text.find(closing, begin) - begin));
    }
    return scripts;
}

} // namespace

TEST_SUITE("script reference")
{
    TEST_CASE("Every script on the page runs and leaves a sound solid")
    {
        const std::vector<std::string> scripts = scripts_of(page());
        REQUIRE(scripts.size() == 4);
        for (const std::string& script : scripts) {
            CAPTURE(script);
            ScriptRunner runner;
            REQUIRE_NOTHROW(run_script(runner, script, {}));
            for (const NamedSolid& solid : runner.solids()) CHECK_NOTHROW(validate(solid.solid));
        }
    }

    TEST_CASE("The page shows each operator's line as the program asks for it")
    {
        const std::string text = page();
        for (const char* word : {"mvfs",  "kvfs", "mev", "split", "kev",  "mef",    "kef",  "kemr",  "mekr", "kfmrh",
                                 "mfkrh", "mvr",  "kvr", "semv",  "jekv", "ringmv", "move", "sweep", "undo", "redo"}) {
            CAPTURE(std::string(word));
            ScriptRunner runner;
            std::string usage;
            try {
                runner.run_line(std::string(word) + " a b c d e f g h i j k l");
            } catch (const LineError& fault) {
                usage =
                    std::string(fault.what()).substr(std::string(word).size() + std::string(" is written: ").size());
            }
            if (usage == "kvfs S [F]") usage = "kvfs S F";
            CHECK(text.find("`" + usage) != std::string::npos);
        }
    }
}
