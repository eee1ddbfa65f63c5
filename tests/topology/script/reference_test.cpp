// The reference pages of the scripts: what they show runs, and they leave no operator out.
#include <doctest/doctest.h>

#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include "tests/text_of.h"
#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/script/script_runner.h"
#include "topology/text/line_error.h"

using namespace topology;

namespace {

std::string page() { return text_of_source("courseware/reference/euler-scripts.md"); }
std::string page_of_arguments() { return text_of_source("courseware/reference/euler-operators.md"); }

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
    TEST_CASE("Every script on the pages runs and leaves a sound solid")
    {
        std::vector<std::string> scripts = scripts_of(page());
        REQUIRE(scripts.size() == 4);
        for (const std::string& script : scripts_of(page_of_arguments())) scripts.push_back(script);
        REQUIRE(scripts.size() == 6);
        for (const std::string& script : scripts) {
            CAPTURE(script);
            ScriptRunner runner;
            REQUIRE_NOTHROW(run_script(runner, script, {}));
            for (const NamedSolid& solid : runner.solids()) CHECK_NOTHROW(validate(solid.solid));
        }
    }

    TEST_CASE("Each line that the page of arguments sets beside Mantyla's is one of the scripts' page")
    {
        const std::string text = page_of_arguments(), scripts = page();
        std::size_t n_lines = 0;
        for (std::size_t begin = text.find("| `"); begin != std::string::npos; begin = text.find("| `", begin + 1)) {
            const std::string line = text.substr(begin + 3, text.find('`', begin + 3) - begin - 3);
            if (line.find("::") != std::string::npos) continue; // a link of a class
            CAPTURE(line);
            CHECK(scripts.find("`" + (line == "kvfs S [F]" ? "kvfs S F" : line) + "`") != std::string::npos);
            ++n_lines;
        }
        CHECK(n_lines == 13);
    }

    TEST_CASE("The drawing of the classes and its table show every link that the entities have")
    {
        const std::string drawing = text_of_source("courseware/reference/half-edge-classes.svg"),
                          table = page_of_arguments();
        std::istringstream entities(text_of_source("topology/halfedge/entities.h"));
        std::string name;
        for (std::string line; std::getline(entities, line);) {
            if (line.starts_with("struct ")) name = line.substr(7, line.find(' ', 7) - 7);
            if (!line.starts_with("    ") || line.find(" = nothing<") == std::string::npos) continue;
            CHECK(drawing.find(">" + name + "<") != std::string::npos);
            CHECK(table.find("`" + name + "::") != std::string::npos);
            for (std::istringstream words(line.substr(0, line.find("; "))); words >> line;) {
                const bool is_field = std::islower(static_cast<unsigned char>(line.front())) != 0 &&
                                      !line.starts_with("nothing");
                if (!is_field) continue;
                CAPTURE(line);
                CHECK(drawing.find(">" + line + "<") != std::string::npos);
                CHECK(table.find(line + "`") != std::string::npos);
            }
        }
        CHECK(name == "Face");
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
